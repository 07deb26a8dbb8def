#pragma once

#include "common/body.hpp"

#include <vector>

namespace isostretch::app::manipulate {

// Of every element the least eigenvalue of S = sym(R^T F), with R [element][dim * dim] row by row.
std::vector<double> least_eigenvalues(const Body& body, const std::vector<double>& rotations,
                                      const Vector& positions);

}  // namespace isostretch::app::manipulate
