#include "common/validators.hpp"

#include <isostretch/core/choice_names.hpp>
#include <isostretch/core/numbers.hpp>
#include <isostretch/core/text.hpp>

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
