#pragma once

// Disks that make floating point suffer.
#include <isostretch/mesh/types.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <numbers>
#include <utility>
#include <vector>

namespace isostretch::parameterization::test {

// (n + 1) x (m + 1) vertices at position(i, j).
inline mesh::SurfaceMesh grid_at(int n, int m,
                                 const std::function<std::array<double, 3>(int, int)>& position) {
  mesh::SurfaceMesh mesh;
  mesh.vertices.resize((n + 1) * (m + 1), 3);
  mesh.triangles.resize(2 * n * m, 3);
  int t = 0;
  for (int i = 0; i <= n; ++i)
    for (int j = 0; j <= m; ++j) {
      const auto p = position(i, j);
      const int v = i * (m + 1) + j;
      mesh.vertices.row(v) << p[0], p[1], p[2];
      if (i == n || j == m) continue;
      mesh.triangles.row(t++) << v, v + m + 1, v + m + 2;
      mesh.triangles.row(t++) << v, v + m + 2, v + 1;
    }
  return mesh;
}

// Spacings that shrink from 1 to 1e-6 in both directions: areas from 1 to 1e-12.
inline mesh::SurfaceMesh graded(int n) {
  std::vector<double> at{0};
  for (int i = 0; i < n; ++i) at.push_back(at.back() + std::pow(1e-6, static_cast<double>(i) / (n - 1)));
  return grid_at(n, n, [&](int i, int j) {
    return std::array<double, 3>{at[static_cast<std::size_t>(i)], at[static_cast<std::size_t>(j)],
                                 0.1 * std::sin(at[static_cast<std::size_t>(i)])};
  });
}

// Triangles of that height and base 1, on a curved sheet that can be flattened.
inline mesh::SurfaceMesh needles(int n, double height) {
  return grid_at(n, n, [&](int i, int j) {
    return std::array<double, 3>{static_cast<double>(i), height * j, 0.05 * i * i / n};
  });
}

// A closed-end tube, `length` rings of triangles long and `around` wide: Tutte's embedding shrinks its far
// end by exp(-2 pi length / around).
inline mesh::SurfaceMesh finger(int around, int length) {
  mesh::SurfaceMesh mesh;
  mesh.vertices.resize(around * (length + 1) + 1, 3);
  mesh.triangles.resize(2 * around * length + around, 3);
  const double radius = around / (2 * std::numbers::pi);
  const int tip = around * (length + 1);
  int t = 0;
  for (int i = 0; i <= length; ++i)
    for (int j = 0; j < around; ++j) {
      const double angle = 2 * std::numbers::pi * j / around;
      const int v = i * around + j, next = i * around + (j + 1) % around;
      mesh.vertices.row(v) << radius * std::cos(angle), radius * std::sin(angle), i;
      if (i < length) {
        mesh.triangles.row(t++) << v, next, next + around;
        mesh.triangles.row(t++) << v, next + around, v + around;
      } else {
        mesh.triangles.row(t++) << v, next, tip;
      }
    }
  mesh.vertices.row(tip) << 0, 0, length + radius;
  return mesh;
}

// The x and y of place d along the Hilbert curve that fills side x side cells.
inline std::pair<int, int> hilbert(int side, int d) {
  int x = 0, y = 0;
  for (int s = 1; s < side; s *= 2, d /= 4) {
    const int rx = 1 & (d / 2), ry = 1 & (d ^ rx);
    if (ry == 0) {
      if (rx == 1) x = s - 1 - x, y = s - 1 - y;
      std::swap(x, y);
    }
    x += s * rx;
    y += s * ry;
  }
  return {x, y};
}

// A corridor three cells wide along the Hilbert curve through side x side places, with walls one cell wide.
inline mesh::SurfaceMesh hilbert_corridor(int side) {
  std::map<std::pair<int, int>, bool> cells;
  const auto fill = [&](int x, int y) {
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) cells[{4 * x + i, 4 * y + j}] = true;
  };
  auto last = hilbert(side, 0);
  fill(last.first, last.second);
  for (int d = 1; d < side * side; ++d) {
    const auto next = hilbert(side, d);
    fill(next.first, next.second);
    for (int k = 0; k < 3; ++k)
      if (next.second == last.second)
        cells[{4 * std::min(next.first, last.first) + 3, 4 * last.second + k}] = true;
      else
        cells[{4 * last.first + k, 4 * std::min(next.second, last.second) + 3}] = true;
    last = next;
  }
  std::map<std::pair<int, int>, int> numbers;
  std::vector<double> points;
  const auto vertex = [&](int x, int y) {
    const auto [at, fresh] = numbers.emplace(std::pair(x, y), static_cast<int>(numbers.size()));
    if (fresh) points.insert(points.end(), {double(x), double(y), 0.0});
    return at->second;
  };
  std::vector<int> triangles;
  for (const auto& [cell, filled] : cells) {
    const int a = vertex(cell.first, cell.second), b = vertex(cell.first + 1, cell.second),
              c = vertex(cell.first + 1, cell.second + 1), d = vertex(cell.first, cell.second + 1);
    triangles.insert(triangles.end(), {a, b, c, a, c, d});
  }
  mesh::SurfaceMesh mesh;
  mesh.vertices = Eigen::Map<mesh::Points3>(points.data(), std::ssize(points) / 3, 3);
  mesh.triangles = Eigen::Map<mesh::Triangles>(triangles.data(), std::ssize(triangles) / 3, 3);
  return mesh;
}

}  // namespace isostretch::parameterization::test
