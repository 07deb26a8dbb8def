#include "five_tets.hpp"
#include "generator_checks.hpp"

#include <isostretch/mesh/generators.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace isostretch::mesh {
namespace {

using Vector3 = Eigen::Vector3d;

// Which of the nested cubes with rounded edges the point of [-1, 1]^3 is on: half as wide as t, the radius of
// the edges is t (1 - t). They lead from spheres at the centre to the cube without kinks on the way, as the
// largest coordinate would have them, over which tetrahedra would be flat.
double rounded_level(const Eigen::Vector3d& point) {
  if (point.cwiseAbs().maxCoeff() >= 1) return 1;
  double low = 0, high = 1;
  for (int step = 0; step < 60; ++step) {
    const double t = 0.5 * (low + high);
    const Eigen::Vector3d beyond = (point.cwiseAbs().array() - t * t).max(0.0);
    (beyond.norm() > t - t * t ? low : high) = t;
  }
  return high;
}

}  // namespace

TetMesh tet_bar(int nx, int ny, int nz, double size_x, double size_y, double size_z) {
  const int n[3] = {nx, ny, nz};
  const double size[3] = {size_x, size_y, size_z};
  const char* count_name[3] = {"nx", "ny", "nz"};
  const char* size_name[3] = {"size_x", "size_y", "size_z"};
  for (int d = 0; d < 3; ++d) {
    require_count(count_name[d], n[d]);
    require_length(size_name[d], size[d]);
  }
  require_indexable(6.0 * nx * ny * nz);
  const auto vertex = [&](int i, int j, int k) { return (k * (ny + 1) + j) * (nx + 1) + i; };
  TetMesh mesh;
  mesh.vertices.resize((nx + 1) * (ny + 1) * (nz + 1), 3);
  for (int k = 0; k <= nz; ++k)
    for (int j = 0; j <= ny; ++j)
      for (int i = 0; i <= nx; ++i)
        mesh.vertices.row(vertex(i, j, k)) << size_x * i / nx, size_y * j / ny, size_z * k / nz;
  // Kuhn's six: along every order of the axes from one corner of the box to the opposite one.
  const int orders[6][3] = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}};
  mesh.tets.resize(6 * nx * ny * nz, 4);
  int t = 0;
  for (int k = 0; k < nz; ++k)
    for (int j = 0; j < ny; ++j)
      for (int i = 0; i < nx; ++i)
        for (int order = 0; order < 6; ++order) {
          int at[3] = {i, j, k}, corner[4] = {vertex(i, j, k), 0, 0, 0};
          for (int step = 0; step < 3; ++step) {
            ++at[orders[order][step]];
            corner[step + 1] = vertex(at[0], at[1], at[2]);
          }
          if (order >= 3) std::swap(corner[1], corner[2]);  // odd orders come out inverted
          mesh.tets.row(t++) << corner[0], corner[1], corner[2], corner[3];
        }
  return mesh;
}

TetMesh ball(int n) {
  require_count("n", n, 2);
  if (n % 2 != 0) throw Error("n is " + std::to_string(n) + ", must be even");
  require_indexable(4.0 * n * n * n);
  const auto number = [&](const Place& p) { return (p.i * (n + 1) + p.j) * (n + 1) + p.k; };
  TetMesh mesh;
  mesh.vertices.resize((n + 1) * (n + 1) * (n + 1), 3);
  std::vector<std::array<int, 4>> tets;
  for (int i = 0; i <= n; ++i)
    for (int j = 0; j <= n; ++j)
      for (int k = 0; k <= n; ++k) {
        const Vector3 p = Vector3(2 * i - n, 2 * j - n, 2 * k - n) / n;
        mesh.vertices.row(number({i, j, k})) = (rounded_level(p) * p.stableNormalized()).transpose();
        if (i < n && j < n && k < n) append_five(tets, {i, j, k}, number);
      }
  mesh.tets = rows_of(tets);
  return mesh;
}

}  // namespace isostretch::mesh
