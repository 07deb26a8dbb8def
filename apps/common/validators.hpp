#pragma once

#include <CLI/CLI.hpp>

namespace isostretch::app {

// Checks for options of CLI11, which takes "nan" and "1e400" for numbers on its own.
CLI::Validator not_negative();
CLI::Validator positive();
CLI::Validator whole_number_between(int lowest, int highest);

}  // namespace isostretch::app
