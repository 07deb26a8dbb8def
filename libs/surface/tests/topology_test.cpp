// Sides of triangles in the order of their edges, whatever the numbers of the vertices.
#include <isostretch/surface/topology.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <functional>
#include <random>
#include <tuple>
#include <vector>

using namespace isostretch::mesh;

namespace {

Triangles drawn(int count, const std::function<int()>& vertex) {
  Triangles triangles(count, 3);
  for (int t = 0; t < count; ++t)
    for (int corner = 0; corner < 3; ++corner) triangles(t, corner) = vertex();
  return triangles;
}

auto key(const Side& side) {
  return std::tuple(side.low, side.high, side.triangle, side.corner);
}

}  // namespace

TEST_CASE("sides ascend by edge and triangle, for few vertices, many, and numbers that are no vertices") {
  std::mt19937 random(3);
  const auto below = [&](int end) { return static_cast<int>(random() % static_cast<unsigned>(end)); };
  const Triangles meshes[] = {
      drawn(500, [&] { return below(300); }), drawn(500, [&] { return below(5); }),
      drawn(500, [&] { return below(2'000'000'000) - 1'000'000'000; }), drawn(1, [&] { return below(9); }),
      drawn(0, [&] { return 0; }),
      // A fan: all edges end in one vertex.
      drawn(500, [&, corner = 0]() mutable { return corner++ % 3 == 0 ? 0 : below(400) + 1; })};
  for (const Triangles& triangles : meshes) {
    const std::vector<Side> sides = sorted_sides(triangles);
    CHECK(std::is_sorted(sides.begin(), sides.end(),
                         [](const Side& a, const Side& b) { return key(a) < key(b); }));
    std::size_t expected = 0;
    for (Eigen::Index t = 0; t < triangles.rows(); ++t) {
      const int a = triangles(t, 0), b = triangles(t, 1), c = triangles(t, 2);
      if (a != b && b != c && c != a) expected += 3;
    }
    CHECK(sides.size() == expected);
    for (const Side& side : sides) {
      CHECK(side.from() == triangles(side.triangle, side.corner));
      CHECK(side.to() == triangles(side.triangle, (side.corner + 1) % 3));
    }
  }
}
