#pragma once

#include "half_edges.hpp"

#include <vector>

namespace isostretch::mesh {

// Where to cut is decided by comparing lengths, and symmetric models are full of equal ones. Lengths here are
// multiplied by 1 + 0.02 g, where g is a fixed function without symmetries of the place relative to the
// bounding box: what is compared is then different by far more than rounding, and a choice depends on
// geometry, never on numbering.
class GenericFunction {
 public:
  explicit GenericFunction(const Points3& vertices);
  // All vertices are in one place.
  bool without_extent() const { return scale_ == 0; }
  // In [-1, 1].
  double operator()(double x, double y, double z) const;
  // A direction without symmetries: whose largest value marks an extreme vertex.
  double height(double x, double y, double z) const;

 private:
  double centre_[3] = {0, 0, 0};
  double scale_ = 0;
};

// For each half-edge, the same for both of an edge. Where everything is in one place edges count as one.
std::vector<double> generic_weights(const HalfEdges& surface, const Points3& vertices);

// The vertex of largest height.
int extreme_vertex(const Points3& vertices);

}  // namespace isostretch::mesh
