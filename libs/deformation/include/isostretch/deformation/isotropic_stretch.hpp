#pragma once

#include <isostretch/deformation/solid_model.hpp>

#include <vector>

namespace isostretch::deformation {

/// Returns for every element the least eigenvalue of S = sym(R^T F), with R [element][dim * dim] column by
/// column.
std::vector<double> least_eigenvalues(const SolidModel& body, const std::vector<double>& rotations,
                                      const Vector& positions);

}  // namespace isostretch::deformation
