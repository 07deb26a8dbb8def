#pragma once

#include <isostretch/comparison/manipulation_report.hpp>

#include <string>

namespace isostretch::comparison {

/// Returns a picture of the last frame that was made, as PNG: the body at rest, by the unconstrained
/// minimiser, and the result.
std::string draw_states(const ManipulationReport& report, const deformation::Strain& strain);

/// Returns a picture of the way to the last frame, as PNG: iterates, and over the seconds how many elements
/// are inverted and how much lower the energy could be.
std::string draw_path(const ManipulationReport& report, const deformation::Strain& strain);

}  // namespace isostretch::comparison
