#pragma once

#include <isostretch/core/choice_names.hpp>

#include <functional>
#include <limits>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace isostretch {

/// The numbers that an option may be, from `lowest` to `highest`. NaN is in no range.
struct Range {
  /// The lowest number.
  double lowest = std::numeric_limits<double>::lowest();
  double highest = std::numeric_limits<double>::infinity();  ///< infinity: an infinite value is allowed, too
  bool without_lowest = false;                               ///< the range is open below
  bool without_highest = false;                              ///< the range is open above

  /// Returns whether the number is in the range.
  bool contains(double number) const noexcept;
  /// Returns the range in words, such as "a number > 0" or "a whole number from 1 to 5".
  std::string in_words(bool whole) const;
};

/// Returns the range of numbers not below `lowest`.
constexpr Range at_least(double lowest) {
  return {.lowest = lowest};
}
/// Returns the range of numbers above `lowest`.
constexpr Range above(double lowest) {
  return {.lowest = lowest, .without_lowest = true};
}
/// Returns the range from `lowest` to `highest`, with both.
constexpr Range between(double lowest, double highest) {
  return {lowest, highest, false, false};
}
/// Returns the range from `lowest` to `highest`, without both.
constexpr Range inside(double lowest, double highest) {
  return {lowest, highest, true, true};
}
/// Returns the range without its upper end.
constexpr Range below_highest(Range range) {
  range.without_highest = true;
  return range;
}
/// Returns the range without infinity.
constexpr Range finite(Range range) {
  range.highest = std::numeric_limits<double>::max();
  return range;
}

/// A description of an option: its name, what it does and what it may be, said once for command lines,
/// scenes, checks and, what it does and what it may be, said once for command lines, scenes, checks and
/// documentation.
struct Field {
  /// The key in scenes; the flag has - for _.
  const char* name;
  const char* help;  ///< one sentence without its full stop, for who does not know the code
  /// The range of a number.
  Range range = {};
  const char* unit = "";  ///< such as "seconds"; empty: none
  bool expert = false;    ///< has no flag of its own on command lines
};

struct OptionField;

/// A member that is one of an enumeration's choices, by their names.
struct ChoiceSlot {
  /// Returns the names there are.
  std::function<std::vector<std::string>()> names;
  /// Returns the name of the choice that the member has.
  std::function<std::string()> get;
  std::function<void(const std::string&)> set;  ///< takes one of names()
};

/// The member that a field describes. The last: options inside of options.
using OptionSlot = std::variant<bool*, int*, double*, std::string*, ChoiceSlot, std::vector<OptionField>>;

/// A field with the member it describes.
struct OptionField {
  /// The description of the member.
  Field field;
  /// The member.
  OptionSlot slot;
};

/// Options that describe their members: Options::fields(options, visit) calls visit(Field, member) for each.
template <class Options>
concept DescribedOptions = requires(Options& options) {
  Options::fields(options, [](const Field&, auto&) {});
};

template <DescribedOptions Options>
std::vector<OptionField> option_fields(Options& options);

/// Adds a field with its slot to the others.
void append_field(std::vector<OptionField>& fields, const Field& field, OptionSlot slot);

/// Returns the slot of a member: a bool, int, double, std::string, described options, or an enumeration.
/// Beside the enumeration stands choice_names(Member), which returns its ChoiceNames, or
/// choice_slot(Member&), where choices can be added while a program runs.
template <class Member>
OptionSlot option_slot(Member& member) {
  if constexpr (DescribedOptions<Member>) {
    return option_fields(member);
  } else if constexpr (requires { choice_slot(member); }) {
    return choice_slot(member);
  } else if constexpr (std::is_enum_v<Member>) {
    return ChoiceSlot{
        [] { return all_names(choice_names(Member{})); },
        [&member] { return std::string(name_of(choice_names(Member{}), member)); },
        [&member](const std::string& name) { member = choice_of(choice_names(Member{}), name); }};
  } else {
    return &member;
  }
}

/// Returns the fields of the options, which must live longer.
template <DescribedOptions Options>
std::vector<OptionField> option_fields(Options& options) {
  std::vector<OptionField> all;
  Options::fields(
      options, [&all](const Field& field, auto& member) { append_field(all, field, option_slot(member)); });
  return all;
}

/// Throws OptionError naming the first number that is outside of its range, such as "penalty.epsilon".
void check_ranges(const std::vector<OptionField>& fields);

/// Throws OptionError naming the first number of the options that is outside of its range.
template <DescribedOptions Options>
void check_ranges(const Options& options) {
  Options copy = options;
  check_ranges(option_fields(copy));
}

}  // namespace isostretch
