#pragma once

#include <isostretch/comparison/method_comparison.hpp>

#include <string>

namespace isostretch::comparison {

/// Returns a CSV table with a row for every run; what is not known, or never reached, is empty.
std::string run_table(const MethodComparison& comparison);
/// Returns a CSV table with a row for every method on every problem; what is not known, or never reached, is
/// empty.
std::string method_table(const MethodComparison& comparison);

/// Returns everything but the traces as the text of comparison.json.
std::string comparison_json(const MethodComparison& comparison);

}  // namespace isostretch::comparison
