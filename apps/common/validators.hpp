#pragma once

#include <isostretch/core/option_fields.hpp>

#include <CLI/CLI.hpp>

#include <functional>
#include <string>
#include <vector>

namespace isostretch::app {

// Checks for options of CLI11, which takes "nan" and "1e400" for numbers on its own and "nan" for one in any
// range. They have no description of their own for --help: what an option takes is said there.

/// A number, or a whole number, of a range.
CLI::Validator in_range(const Range& range, bool whole);
/// One of these names.
CLI::Validator one_of(const std::vector<std::string>& names);
/// One of the names that there are when the command line is read, which plug-ins may have added to.
CLI::Validator one_of(std::function<std::vector<std::string>()> names);

}  // namespace isostretch::app
