#pragma once

#include "stiffness.hpp"

#include <vector>

namespace isostretch::handles {

// Of the systems A w = 0 at free nodes: constants solve them, so that a connected part of the free nodes
// takes the value given around it where that is one and the same. Fills such parts into w, `columns` vectors
// one after the other, and returns the nodes that are left to solve for. A system would get these values
// wrong by rounding, and bounds would not be met exactly.
std::vector<bool> solve_constant_parts(const Rows& A, const std::vector<bool>& free, std::vector<double>& w,
                                       int columns);

}  // namespace isostretch::handles
