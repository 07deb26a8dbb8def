#include "common/numbers.hpp"

#include <charconv>
#include <cmath>

namespace isostretch::app {
namespace {

template <class Number>
std::optional<Number> parse(std::string_view text) {
  if (text.size() > 1 && text.front() == '+' && text[1] != '-') text.remove_prefix(1);
  Number value{};
  const auto result = std::from_chars(text.data(), text.data() + text.size(), value);
  if (text.empty() || result.ec != std::errc{} || result.ptr != text.data() + text.size()) return {};
  return value;
}

std::string in_quotes(const std::string& text) {
  return "'" + text + "'";
}

}  // namespace

std::optional<double> finite_number(std::string_view text) {
  const auto value = parse<double>(text);
  return value && std::isfinite(*value) ? value : std::nullopt;
}

std::optional<int> whole_number(std::string_view text) {
  return parse<int>(text);
}

std::string exact_text(double value) {
  char buffer[32];
  return {buffer, std::to_chars(buffer, buffer + sizeof buffer, value).ptr};
}

std::vector<std::string> split(std::string_view text, char separator) {
  std::vector<std::string> parts;
  for (std::size_t start = 0; start <= text.size();) {
    const std::size_t end = std::min(text.find(separator, start), text.size());
    parts.emplace_back(text.substr(start, end - start));
    start = end + 1;
  }
  return parts;
}

CLI::Validator not_negative() {
  return {[](std::string& text) {
            const auto value = finite_number(text);
            return value && *value >= 0 ? std::string() : in_quotes(text) + " is not a number >= 0";
          },
          "NUMBER>=0"};
}

CLI::Validator positive() {
  return {[](std::string& text) {
            const auto value = finite_number(text);
            return value && *value > 0 ? std::string() : in_quotes(text) + " is not a number > 0";
          },
          "NUMBER>0"};
}

CLI::Validator whole_number_between(int lowest, int highest) {
  const std::string range = std::to_string(lowest) + " to " + std::to_string(highest);
  return {[=](std::string& text) {
            const auto value = whole_number(text);
            return value && *value >= lowest && *value <= highest
                       ? std::string()
                       : in_quotes(text) + " is not a whole number from " + range;
          },
          range};
}

}  // namespace isostretch::app
