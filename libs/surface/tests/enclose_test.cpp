#include <isostretch/core/error.hpp>
#include <isostretch/mesh/generators.hpp>
#include <isostretch/surface/cut.hpp>

#include <doctest/doctest.h>

#include <Eigen/Geometry>

#include <cmath>
#include <cstddef>
#include <vector>

using namespace isostretch;
using namespace isostretch::mesh;

TEST_CASE("enclose: the cap of a mushroom by the narrowest ring of its stem") {
  // Rings of vertices around the z axis, from the boundary up; the last one is closed by a vertex.
  constexpr int segments = 12;
  const double radius[] = {5, 4, 2, 0.6, 0.5, 0.55, 2, 2.5, 1.5}, height[] = {0, 0, 0, 0.5, 1, 1.5, 2, 3, 4};
  constexpr int rings = 9, narrowest = 4;
  SurfaceMesh mushroom;
  mushroom.vertices.resize(rings * segments + 1, 3);
  mushroom.triangles.resize((rings - 1) * segments * 2 + segments, 3);
  int t = 0;
  for (int r = 0; r < rings; ++r)
    for (int s = 0; s < segments; ++s) {
      const double angle = 2 * M_PI * s / segments;
      mushroom.vertices.row(r * segments + s) << radius[r] * std::cos(angle), radius[r] * std::sin(angle),
          height[r];
      const int next = (s + 1) % segments, a = r * segments + s, b = r * segments + next;
      if (r + 1 == rings) {
        mushroom.triangles.row(t++) << a, b, rings * segments;
      } else {
        mushroom.triangles.row(t++) << a, b, b + segments;
        mushroom.triangles.row(t++) << a, b + segments, a + segments;
      }
    }
  mushroom.vertices.row(rings * segments) << 0, 0, 4.5;
  const Cut cut = cut_to_disks(mushroom);
  const Encloser encloser(cut);
  std::vector<int> cap, above;
  for (int i = 0; i < t; ++i) {
    if (i >= 7 * 2 * segments) cap.push_back(i);
    if (i >= narrowest * 2 * segments) above.push_back(i);
  }
  const double ring = segments * 2 * 0.5 * std::sin(M_PI / segments);
  const Enclosure found = encloser.enclose(cap, 100);
  CHECK(found.length == doctest::Approx(ring).epsilon(1e-7));
  CHECK(found.triangles == above);
  double area = 0;
  for (const int i : above) {
    const auto p = [&](int c) -> Eigen::RowVector3d {
      return mushroom.vertices.row(mushroom.triangles(i, c));
    };
    area += (p(1) - p(0)).cross(p(2) - p(0)).norm() / 2;
  }
  CHECK(found.area == doctest::Approx(area));
  const SurfaceMesh closed = icosphere(1);
  const Cut whole{closed, {}, std::vector<int>(static_cast<std::size_t>(closed.triangles.rows()), 0), {}, {}};
  CHECK(Encloser(whole).enclose({0}, 100).triangles.empty());  // no boundary
  CHECK(encloser.enclose(cap, 0.99 * ring).triangles.empty());
  CHECK(encloser.enclose(cap, 1.01 * ring).triangles == above);
  CHECK(encloser.enclose({t - 1}, 100).triangles == above);    // its own sides are longer
  CHECK(encloser.enclose({0, t - 1}, 100).triangles.empty());  // on the boundary
  CHECK(encloser.enclose({}, 100).triangles.empty());
  CHECK_THROWS_WITH_AS(encloser.enclose({t}, 100), doctest::Contains("there is no triangle"), Error);
}
