#include <isostretch/core/to_text.hpp>

#include <charconv>
#include <iterator>

namespace isostretch {

std::string to_text(double value) {
  char text[32];
  const auto [end, error] = std::to_chars(std::begin(text), std::end(text), value);
  return {text, end};
}

}  // namespace isostretch
