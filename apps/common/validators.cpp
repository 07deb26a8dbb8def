#include "common/validators.hpp"

#include <isostretch/core/numbers.hpp>

#include <isostretch/core/choice_names.hpp>
#include <isostretch/core/text.hpp>
#include <isostretch/core/to_text.hpp>

#include <algorithm>
#include <string>

namespace isostretch::app {
namespace {

std::string in_quotes(const std::string& text) {
  return "'" + text + "'";
}

}  // namespace

CLI::Validator in_range(const Range& range, bool whole) {
  return {[=](std::string& text) {
            const auto value = finite_number(text);
            const bool is = value && range.contains(*value) && (!whole || whole_number(text));
            return is ? std::string() : in_quotes(text) + " is not " + range.in_words(whole);
          },
          ""};
}

CLI::Validator not_negative() {
  return {[](std::string& text) {
            const auto value = finite_number(text);
            return value && *value >= 0 ? std::string() : in_quotes(text) + " is not a number >= 0";
          },
          ""};
}

CLI::Validator positive() {
  return {[](std::string& text) {
            const auto value = finite_number(text);
            return value && *value > 0 ? std::string() : in_quotes(text) + " is not a number > 0";
          },
          ""};
}

CLI::Validator number_between(double lowest, double highest) {
  const std::string range = to_text(lowest) + " to " + to_text(highest);
  return {[=](std::string& text) {
            const auto value = finite_number(text);
            return value && *value >= lowest && *value <= highest
                       ? std::string()
                       : in_quotes(text) + " is not a number from " + range;
          },
          ""};
}

CLI::Validator whole_number_between(int lowest, int highest) {
  const std::string range = std::to_string(lowest) + " to " + std::to_string(highest);
  return {[=](std::string& text) {
            const auto value = whole_number(text);
            return value && *value >= lowest && *value <= highest
                       ? std::string()
                       : in_quotes(text) + " is not a whole number from " + range;
          },
          ""};
}

CLI::Validator one_of(std::function<std::vector<std::string>()> names) {
  return {[=](std::string& text) {
            const std::vector<std::string> all = names();
            return std::find(all.begin(), all.end(), text) != all.end()
                       ? std::string()
                       : in_quotes(text) + " is none of " + listed(all);
          },
          ""};
}

CLI::Validator one_of(const std::vector<std::string>& names) {
  return one_of([names] { return names; });
}

}  // namespace isostretch::app
