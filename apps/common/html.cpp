#include "common/html.hpp"

#include <isostretch/core/text.hpp>

namespace isostretch::app {

std::string number(const Json& value, const char* pattern) {
  return value.is_number() ? formatted(pattern, value.get<double>()) : std::string("–");
}

}  // namespace isostretch::app
