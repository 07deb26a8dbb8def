#include "number.hpp"

#include <charconv>
#include <cmath>
#include <system_error>

namespace isostretch::mesh {
namespace {

// from_chars leaves numbers below the range (1e-400) to the caller as it does those above.
bool is_tiny(std::string_view word) {
  const std::size_t exponent = word.find_first_of("eE");
  if (exponent != std::string_view::npos) return exponent + 1 < word.size() && word[exponent + 1] == '-';
  return word.find_first_not_of("+-0") == word.find('.');
}

// from_chars takes no plus sign.
std::size_t plus_sign(std::string_view word) {
  return word.size() > 1 && word[0] == '+' && word[1] != '-' ? 1 : 0;
}

}  // namespace

std::string quoted(std::string_view word) {
  constexpr std::size_t longest = 40;
  std::string text(1, '\'');
  for (const char c : word.substr(0, longest)) text += c >= ' ' && c <= '~' ? c : '?';
  text += word.size() > longest ? "...'" : "'";
  return text;
}

Parsed<std::int64_t> parse_integer(std::string_view word) {
  const std::size_t sign = plus_sign(word);
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(word.data() + sign, word.data() + word.size(), value);
  if (error == std::errc::result_out_of_range) return {0, quoted(word) + " is too large"};
  if (error != std::errc() || end != word.data() + word.size()) return {0, "expected, not " + quoted(word)};
  return {value, {}};
}

Parsed<double> parse_coordinate(std::string_view word) {
  const std::size_t sign = plus_sign(word);
  double value = 0;
  const auto [end, error] = std::from_chars(word.data() + sign, word.data() + word.size(), value);
  if (error == std::errc::result_out_of_range) {
    if (is_tiny(word)) return {};
    return {0, quoted(word) + " is too large"};
  }
  if (error != std::errc() || end != word.data() + word.size()) return {0, quoted(word) + " is not a number"};
  if (!std::isfinite(value)) return {0, quoted(word) + " is not finite"};
  return {value, {}};
}

}  // namespace isostretch::mesh
