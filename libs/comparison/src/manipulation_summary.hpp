#pragma once

#include "json.hpp"

#include <isostretch/comparison/manipulation_report.hpp>

namespace isostretch::comparison {

// What summary.json holds.
Json summary_json(const ManipulationReport& report, const ManipulationSeconds& seconds, int threads);

}  // namespace isostretch::comparison
