#pragma once

#include <isostretch/comparison/manipulation_report.hpp>

#include <string>

namespace isostretch::app::manipulate {

// The last frame made: at rest, before and after; and the way there.
std::string draw_states(const comparison::ManipulationReport& report, const deformation::Strain& strain);
std::string draw_path(const comparison::ManipulationReport& report, const deformation::Strain& strain);

}  // namespace isostretch::app::manipulate
