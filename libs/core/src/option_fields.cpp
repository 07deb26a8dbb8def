#include <isostretch/core/option_fields.hpp>

#include <isostretch/core/error.hpp>
#include <isostretch/core/to_text.hpp>

#include <cmath>
#include <utility>

namespace isostretch {
namespace {

void check(const Field& field, const std::string& path, double number, bool whole) {
  if (!field.range.contains(number))
    throw OptionError(path, "must be " + field.range.in_words(whole) + ", not " + to_text(number));
}

void check_all(const std::vector<OptionField>& fields, const std::string& prefix) {
  for (const auto& [field, slot] : fields) {
    const std::string path = prefix + field.name;
    if (const auto* real = std::get_if<double*>(&slot)) check(field, path, **real, false);
    if (const auto* whole = std::get_if<int*>(&slot)) check(field, path, **whole, true);
    if (const auto* inner = std::get_if<std::vector<OptionField>>(&slot)) check_all(*inner, path + ".");
  }
}

}  // namespace

bool Range::contains(double number) const noexcept {
  return (without_lowest ? number > lowest : number >= lowest) &&
         (without_highest ? number < highest : number <= highest);
}

std::string Range::in_words(bool whole) const {
  const auto to_text = [whole](double number) {
    return whole ? std::to_string(static_cast<long long>(number)) : isostretch::to_text(number);
  };
  const std::string what = whole ? "a whole number" : "a number";
  const bool below = lowest == std::numeric_limits<double>::lowest();
  const bool above = highest >= std::numeric_limits<double>::max();
  if (below && above) return whole ? what : "a finite number";
  if (above) return what + (without_lowest ? " > " : " >= ") + to_text(lowest);
  if (below) return what + (without_highest ? " < " : " <= ") + to_text(highest);
  if (!without_lowest && !without_highest)
    return what + " from " + to_text(lowest) + " to " + to_text(highest);
  return what + (without_lowest ? " > " : " >= ") + to_text(lowest) +
         (without_highest ? " and < " : " and <= ") + to_text(highest);
}

void append_field(std::vector<OptionField>& fields, const Field& field, OptionSlot slot) {
  fields.push_back({field, std::move(slot)});
}

void check_ranges(const std::vector<OptionField>& fields) {
  check_all(fields, "");
}

}  // namespace isostretch
