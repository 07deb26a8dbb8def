#pragma once

#include <isostretch/core/vector.hpp>

namespace isostretch::newton {

/// Returns the diagonal of the bounding box of positions, dim numbers a node.
double bounding_box_diagonal(const Vector& x, int dim);

/// Returns a length that positions have no say in: the last digits of the bounding box and of the
/// coordinates. What an energy gains by moving every node so far is rounding.
double rounding_length(const Vector& x, int dim);

}  // namespace isostretch::newton
