#pragma once

// Small meshes with known faults, by hand.
#include <isostretch/mesh/types.hpp>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <vector>

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

// A strip n x m glued along its sides of m edges: straight (closed = false, turned = false), with a half turn
// (a Moebius strip), and its two rims to each other (a torus, or a Klein bottle that meets itself).
inline SurfaceMesh glued_strip(int n, int m, bool turned, bool closed) {
  SurfaceMesh mesh;
  const int rows_across = closed ? m : m + 1;
  mesh.vertices.resize(n * rows_across, 3);
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < rows_across; ++j) {
      const double a = 6.283185307179586 * i / n, across = closed ? 0 : double(j) / m - 0.5;
      const double b = closed ? 6.283185307179586 * j / m : 0;
      const double twist = turned ? 0.5 * a : 0;
      const double out = closed ? 0.4 * std::cos(b) : across * std::sin(twist);
      const double up = closed ? 0.4 * std::sin(b) : across * std::cos(twist);
      mesh.vertices.row(i * rows_across + j) << (1 + out) * std::cos(a), (1 + out) * std::sin(a), up;
    }
  const auto vertex = [&](int i, int j) {
    if (i == n && turned) j = closed ? 2 * m - j : m - j;
    return i % n * rows_across + (closed ? j % m : j);
  };
  mesh.triangles.resize(2 * n * m, 3);
  for (int i = 0, t = 0; i < n; ++i)
    for (int j = 0; j < m; ++j) {
      mesh.triangles.row(t++) << vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1);
      mesh.triangles.row(t++) << vertex(i, j), vertex(i + 1, j + 1), vertex(i, j + 1);
    }
  return mesh;
}

inline SurfaceMesh tube(int n, int m) {
  return glued_strip(n, m, false, false);
}

// A tube with a fan of triangles over either rim.
inline SurfaceMesh capped_tube(int n, int m) {
  SurfaceMesh mesh = tube(n, m);
  const auto V = static_cast<int>(mesh.vertices.rows()), F = static_cast<int>(mesh.triangles.rows());
  mesh.vertices.conservativeResize(V + 2, 3);
  mesh.vertices.row(V) << 0, 0, -0.5;
  mesh.vertices.row(V + 1) << 0, 0, 0.5;
  mesh.triangles.conservativeResize(F + 2 * n, 3);
  for (int i = 0; i < n; ++i) {
    const int here = i * (m + 1), there = (i + 1) % n * (m + 1);
    mesh.triangles.row(F + 2 * i) << there, here, V;
    mesh.triangles.row(F + 2 * i + 1) << here + m, there + m, V + 1;
  }
  return mesh;
}

// Surface of a slab of cubes, counter-clockwise from outside, with a square hole through it for each handle:
// (4 handles + 1) x 5 x 2 blocks of `size` cubes. As symmetric as can be.
inline SurfaceMesh slab(int handles, int size) {
  const int n[3] = {(4 * handles + 1) * size, 5 * size, 2 * size};
  const auto solid = [&](int x, int y, int z) {
    if (x < 0 || y < 0 || z < 0 || x >= n[0] || y >= n[1] || z >= n[2]) return false;
    const int column = x / size % 4, row = y / size;
    return !(column >= 2 && row >= 2 && row < 4);
  };
  std::vector<int> number(static_cast<std::size_t>((n[0] + 1) * (n[1] + 1) * (n[2] + 1)), -1), triangles;
  std::vector<double> points;
  const auto vertex = [&](const int* p) {
    int& known = number[static_cast<std::size_t>((p[0] * (n[1] + 1) + p[1]) * (n[2] + 1) + p[2])];
    if (known < 0) {
      known = static_cast<int>(points.size() / 3);
      for (int d = 0; d < 3; ++d) points.push_back(double(p[d]) / size);
    }
    return known;
  };
  const auto face = [&](const int* cube, int axis, int step) {
    int corner[4];
    for (int i = 0; i < 4; ++i) {
      int p[3] = {cube[0], cube[1], cube[2]};
      p[axis] += step;
      const int turn = step ? i : 3 - i;
      p[(axis + 1) % 3] += turn == 1 || turn == 2;
      p[(axis + 2) % 3] += turn >= 2;
      corner[i] = vertex(p);
    }
    for (const int i : {0, 1, 2, 0, 2, 3}) triangles.push_back(corner[i]);
  };
  for (int x = 0; x < n[0]; ++x)
    for (int y = 0; y < n[1]; ++y)
      for (int z = 0; z < n[2]; ++z)
        for (int axis = 0; axis < 3 && solid(x, y, z); ++axis)
          for (int step = 0; step < 2; ++step) {
            const int cube[3] = {x, y, z};
            int beyond[3] = {x, y, z};
            beyond[axis] += step ? 1 : -1;
            if (!solid(beyond[0], beyond[1], beyond[2])) face(cube, axis, step);
          }
  return {Points3::Map(points.data(), static_cast<Eigen::Index>(points.size() / 3), 3),
          Triangles::Map(triangles.data(), static_cast<Eigen::Index>(triangles.size() / 3), 3),
          {},
          {}};
}

inline SurfaceMesh octahedron() {
  return surface({1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1},
                 {0, 2, 4, 2, 1, 4, 1, 3, 4, 3, 0, 4, 2, 0, 5, 1, 2, 5, 3, 1, 5, 0, 3, 5});
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
