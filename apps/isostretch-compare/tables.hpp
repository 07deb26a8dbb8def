#pragma once

#include "comparison.hpp"

#include <string>

namespace isostretch::app::compare {

// A row for every run, and one for every method on every problem; what is not known, or never reached, is
// empty.
std::string run_table(const Comparison& comparison);
std::string method_table(const Comparison& comparison);

// Everything but the traces.
Json comparison_json(const Comparison& comparison);

}  // namespace isostretch::app::compare
