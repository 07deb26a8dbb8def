#include <isostretch/mesh/generators.hpp>
#include <isostretch/surface/boundary.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

using namespace isostretch::mesh;

TEST_CASE("distances to the boundary go along edges, and there may be none") {
  const SurfaceMesh mesh = grid(4, 4);
  const std::vector<double> distance = distance_to_boundary(mesh);
  for (Eigen::Index v = 0; v < mesh.vertices.rows(); ++v) {
    const double x = mesh.vertices(v, 0), y = mesh.vertices(v, 1);
    CHECK(distance[static_cast<std::size_t>(v)] == doctest::Approx(std::min({x, y, 1 - x, 1 - y})));
  }
  for (const double d : distance_to_boundary(icosphere(1))) CHECK(std::isinf(d));
}
