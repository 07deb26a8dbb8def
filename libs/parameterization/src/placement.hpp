#pragma once

#include <isostretch/assembly/elements.hpp>
#include <isostretch/core/vector.hpp>
#include <isostretch/parameterization/charts.hpp>

#include <functional>
#include <vector>

namespace isostretch::parameterization {

struct Target {
  int node = -1;
  Point2 at{0, 0};
};

// Where nodes have to go; may depend on where they are.
struct Placement {
  std::function<std::vector<Target>(const Vector& x)> targets;
  std::vector<int> kept;  // nodes that stay meanwhile
};

// Moves nodes of a chart to their targets. Where that turns triangles over and the energy has a barrier, the
// layout is pulled there with soft pins, first weakly, until it can take them. Returns -1, or a triangle (of
// the whole mesh) that is in the way for good. Throws Error when interrupted before that.
int move_to(Vector& x, const Placement& placement, const assembly::Elements& elements,
            const energies::AnyEnergy& energy, const Chart& chart, const Options& options);

// Node by node, the order the solver wants.
Vector positions(const mesh::Points2& uv);
mesh::Points2 points(const Vector& x);

}  // namespace isostretch::parameterization
