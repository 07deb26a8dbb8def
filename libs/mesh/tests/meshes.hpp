#pragma once

// Small meshes with known faults, by hand.
#include <isostretch/mesh/types.hpp>

#include <algorithm>
#include <cmath>
#include <initializer_list>

namespace isostretch::mesh::test {

template <class Matrix>
Matrix rows(std::initializer_list<typename Matrix::Scalar> values) {
  Matrix matrix(static_cast<Eigen::Index>(values.size()) / Matrix::ColsAtCompileTime,
                static_cast<Eigen::Index>(Matrix::ColsAtCompileTime));
  std::copy(values.begin(), values.end(), matrix.data());
  return matrix;
}

inline SurfaceMesh surface(std::initializer_list<double> vertices, std::initializer_list<int> triangles) {
  return {rows<Points3>(vertices), rows<Triangles>(triangles), {}, {}};
}

// Unit square of two triangles.
inline SurfaceMesh square() {
  return surface({0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0}, {0, 1, 2, 0, 2, 3});
}

inline SurfaceMesh tetrahedron() {
  return surface({0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1}, {0, 2, 1, 0, 1, 3, 1, 2, 3, 0, 3, 2});
}

// n x m torus.
inline SurfaceMesh torus(int n, int m) {
  SurfaceMesh mesh;
  mesh.vertices.resize(n * m, 3);
  mesh.triangles.resize(2 * n * m, 3);
  int t = 0;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < m; ++j) {
      const double a = 6.283185307179586 * i / n, b = 6.283185307179586 * j / m;
      mesh.vertices.row(i * m + j) << (2 + std::cos(b)) * std::cos(a), (2 + std::cos(b)) * std::sin(a),
          std::sin(b);
      const int p = i * m + j, q = (i + 1) % n * m + j, r = (i + 1) % n * m + (j + 1) % m,
                s = i * m + (j + 1) % m;
      mesh.triangles.row(t++) << p, q, r;
      mesh.triangles.row(t++) << p, r, s;
    }
  return mesh;
}

// Without the triangles listed (ascending).
inline SurfaceMesh without(const SurfaceMesh& mesh, std::initializer_list<int> dropped) {
  SurfaceMesh result = mesh;
  result.triangles.resize(mesh.triangles.rows() - static_cast<Eigen::Index>(dropped.size()), 3);
  auto next = dropped.begin();
  for (Eigen::Index t = 0, kept = 0; t < mesh.triangles.rows(); ++t)
    if (next != dropped.end() && *next == t)
      ++next;
    else
      result.triangles.row(kept++) = mesh.triangles.row(t);
  return result;
}

}  // namespace isostretch::mesh::test
