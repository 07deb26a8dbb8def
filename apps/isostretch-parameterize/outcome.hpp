#pragma once

#include "report.hpp"

#include <string>
#include <vector>

namespace isostretch::app::parameterize {

// What came of it, in one line: charts, flips, overlap, stretch, whether it converged.
std::string outcome(const Result& result);

// In percent: two digits that count, and zero for zero alone.
std::string share_text(double share);

// What one who wants to use the layout should know before, a sentence each; they end without a full stop.
std::vector<std::string> layout_warnings(const Result& result);

}  // namespace isostretch::app::parameterize
