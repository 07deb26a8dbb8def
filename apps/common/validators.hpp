#pragma once

#include <CLI/CLI.hpp>

namespace isostretch::app {

// Checks for options of CLI11, which takes "nan" and "1e400" for numbers on its own and "nan" for one in any
// range. Every numeric option of an app has one of these; all of them read by finite_number() and
// whole_number().
CLI::Validator not_negative();
CLI::Validator positive();
CLI::Validator number_between(double lowest, double highest);
CLI::Validator whole_number_between(int lowest, int highest);

}  // namespace isostretch::app
