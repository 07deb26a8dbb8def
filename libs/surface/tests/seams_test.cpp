// Seams: those that texture coordinates have, their paths, and spurs.
#include <isostretch/core/error.hpp>
#include <isostretch/mesh/generators.hpp>
#include <isostretch/surface/cut.hpp>
#include <isostretch/surface/seams.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <cstddef>
#include <vector>

using namespace isostretch;
using namespace isostretch::mesh;

TEST_CASE("seams of uv: where the texture coordinates differ, by value") {
  SurfaceMesh mesh = grid(2, 1);
  mesh.uv = mesh.vertices.leftCols<2>();
  mesh.uv_triangles = mesh.triangles;
  CHECK(seams_of_uv(mesh).empty());
  mesh.uv.conservativeResize(8, 2);  // points 6 and 7: copies of 1 and 4, used by the right half
  mesh.uv.row(6) = mesh.uv.row(1);
  mesh.uv.row(7) = mesh.uv.row(4);
  for (int t = 2; t < 4; ++t)
    for (int c = 0; c < 3; ++c) {
      int& point = mesh.uv_triangles(t, c);
      point = point == 1 ? 6 : point == 4 ? 7 : point;
    }
  CHECK(seams_of_uv(mesh).empty());
  mesh.uv(7, 0) += 0.1;
  CHECK(seams_of_uv(mesh) == std::vector<Edge>{{1, 4}});
  CHECK_THROWS_WITH_AS(seams_of_uv(grid(1, 1)), doctest::Contains("no texture coordinates"), Error);
}

TEST_CASE("seam paths: between ends and branches, and around") {
  using Paths = std::vector<std::vector<int>>;
  CHECK(seam_paths({}).empty());
  CHECK(seam_paths({{3, 7}, {2, 3}, {5, 7}}) == Paths{{2, 3, 7, 5}});
  CHECK(seam_paths({{0, 1}, {1, 2}, {0, 2}}) == Paths{{0, 1, 2, 0}});
  CHECK(seam_paths({{0, 1}, {1, 2}, {1, 3}}) == Paths{{0, 1}, {1, 2}, {1, 3}});
  CHECK(seam_paths({{0, 1}, {1, 2}, {2, 3}, {1, 3}}) == Paths{{0, 1}, {1, 2, 3, 1}});
}

TEST_CASE("spurs: branches of one to three edges that end inside the surface") {
  // Vertex (x, y) has number x + 11 y.
  const SurfaceMesh mesh = grid(10, 10);
  const auto cut = [&](std::vector<std::vector<int>> paths) {
    CutOptions options;
    for (const std::vector<int>& path : paths)
      for (std::size_t i = 1; i < path.size(); ++i)
        options.seams.push_back({std::min(path[i - 1], path[i]), std::max(path[i - 1], path[i])});
    return cut_to_disks(mesh, options);
  };
  using Paths = std::vector<std::vector<int>>;
  const std::vector<int> trunk{55, 56, 57, 58, 59, 60, 61, 62, 63};  // from the left side
  CHECK(spurs(cut({})).empty());
  CHECK(spurs(cut({trunk})).empty());
  CHECK(spurs(cut({{55, 56, 57}})) == Paths{{57, 56, 55}});
  CHECK(spurs(cut({trunk, {58, 69}})) == Paths{{69, 58}});
  CHECK(spurs(cut({trunk, {58, 69, 80, 91}})) == Paths{{91, 80, 69, 58}});
  CHECK(spurs(cut({trunk, {58, 69, 80, 91, 102}})).empty());
  CHECK(spurs(cut({trunk, {57, 46}, {59, 70, 81}})) == Paths{{46, 57}, {81, 70, 59}});
  CHECK(spurs(cut({trunk, {63, 64, 65}})).empty());  // from side to side
}
