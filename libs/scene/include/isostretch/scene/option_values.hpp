#pragma once

#include <isostretch/core/option_fields.hpp>
#include <isostretch/scene/node.hpp>

#include <vector>

namespace isostretch::scene {

/// Reads the fields that an object gives into the options behind them; keys that are none of the fields, nor
/// of `others`, are refused. Throws Error naming the key by its path.
void read_options(const Node& object, const std::vector<OptionField>& fields,
                  const std::vector<std::string>& others = {});

/// Reads what an object gives of the options; see read_options() of fields.
template <DescribedOptions Options>
void read_options(const Node& object, Options& options) {
  read_options(object, option_fields(options));
}

/// Returns an object with all fields, but numbers that are not finite, which is what read_options() reads.
Value options_value(const std::vector<OptionField>& fields);

/// Returns an object with all options; see options_value() of fields.
template <DescribedOptions Options>
Value options_value(const Options& options) {
  Options copy = options;
  return options_value(option_fields(copy));
}

/// Returns the JSON Schema of an object with these fields and no others: kinds, ranges, choices, the values
/// they have now as defaults, and what they do.
Value options_schema(const std::vector<OptionField>& fields);

/// Returns a table of the fields in Markdown, a line each: key with its path, what it may be, default, help.
std::string options_table(const std::vector<OptionField>& fields, const std::string& prefix = {});

}  // namespace isostretch::scene
