#include "generator_checks.hpp"

#include <isostretch/mesh/generators.hpp>

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

namespace isostretch::mesh {
namespace {

constexpr double pi = std::numbers::pi;

SurfaceMesh subdivide(const SurfaceMesh& mesh) {
  std::map<std::pair<int, int>, int> middle;
  const auto V = static_cast<int>(mesh.vertices.rows());
  const auto F = static_cast<int>(mesh.triangles.rows());
  SurfaceMesh fine;
  fine.vertices.resize(V + 3 * F / 2, 3);
  fine.vertices.topRows(V) = mesh.vertices;
  fine.triangles.resize(4 * F, 3);
  const auto middle_of = [&](int a, int b) {
    const auto [entry, is_new] = middle.emplace(std::minmax(a, b), V + static_cast<int>(middle.size()));
    if (is_new)
      fine.vertices.row(entry->second) = (mesh.vertices.row(a) + mesh.vertices.row(b)).stableNormalized();
    return entry->second;
  };
  for (int t = 0; t < F; ++t) {
    const int a = mesh.triangles(t, 0), b = mesh.triangles(t, 1), c = mesh.triangles(t, 2);
    const int ab = middle_of(a, b), bc = middle_of(b, c), ca = middle_of(c, a);
    fine.triangles.row(4 * t) << a, ab, ca;
    fine.triangles.row(4 * t + 1) << ab, b, bc;
    fine.triangles.row(4 * t + 2) << ca, bc, c;
    fine.triangles.row(4 * t + 3) << ab, bc, ca;
  }
  return fine;
}

SurfaceMesh icosahedron() {
  const double g = std::numbers::phi;
  SurfaceMesh mesh;
  mesh.vertices.resize(12, 3);
  mesh.vertices << -1, g, 0, 1, g, 0, -1, -g, 0, 1, -g, 0, 0, -1, g, 0, 1, g, 0, -1, -g, 0, 1, -g, g, 0, -1,
      g, 0, 1, -g, 0, -1, -g, 0, 1;
  for (auto row : mesh.vertices.rowwise()) row.normalize();
  mesh.triangles.resize(20, 3);
  mesh.triangles << 0, 11, 5, 0, 5, 1, 0, 1, 7, 0, 7, 10, 0, 10, 11, 1, 5, 9, 5, 11, 4, 11, 10, 2, 10, 7, 6,
      7, 1, 8, 3, 9, 4, 3, 4, 2, 3, 2, 6, 3, 6, 8, 3, 8, 9, 4, 9, 5, 2, 4, 11, 6, 2, 10, 8, 6, 7, 9, 8, 1;
  return mesh;
}

// Vertices of ring k > 0 of a disc begin here; ring k has 6 k of them.
int ring_start(int k) {
  return k == 0 ? 0 : 1 + 3 * k * (k - 1);
}

int ring_vertex(int k, int i) {
  return k == 0 ? 0 : ring_start(k) + i % (6 * k);
}

// One of the six sectors between rings k and k + 1: k + 1 triangles standing on the outer ring, k on the
// inner.
void append_sector(Triangles& triangles, int& t, int k, int sector) {
  const int inner = sector * k, outer = sector * (k + 1);
  for (int i = 0; i <= k; ++i) {
    triangles.row(t++) << ring_vertex(k, inner + i), ring_vertex(k + 1, outer + i),
        ring_vertex(k + 1, outer + i + 1);
    if (i < k)
      triangles.row(t++) << ring_vertex(k, inner + i), ring_vertex(k + 1, outer + i + 1),
          ring_vertex(k, inner + i + 1);
  }
}

double bump(double x, double y, double cx, double cy, double wx, double wy) {
  const double dx = (x - cx) / wx, dy = (y - cy) / wy;
  return std::exp(-dx * dx - dy * dy);
}

// Radial displacement of the head; x to the right, y up, both in the unit disc.
double face_relief(double x, double y) {
  const double nose = 0.38 * bump(x, y, 0, -0.03, 0.07, 0.16);
  const double eyes = bump(x, y, -0.2, 0.17, 0.11, 0.07) + bump(x, y, 0.2, 0.17, 0.11, 0.07);
  const double mouth = 0.08 * bump(x, y, 0, -0.30, 0.16, 0.035) - 0.05 * bump(x, y, 0, -0.30, 0.14, 0.012);
  const double chin = 0.12 * bump(x, y, 0, -0.50, 0.15, 0.1);
  return nose - 0.12 * eyes + mouth + chin;
}

}  // namespace

SurfaceMesh grid(int nx, int ny, double width, double height) {
  require_count("nx", nx);
  require_count("ny", ny);
  require_length("width", width);
  require_length("height", height);
  require_indexable(double(nx) * ny);
  SurfaceMesh mesh;
  mesh.vertices.resize((nx + 1) * (ny + 1), 3);
  for (int j = 0; j <= ny; ++j)
    for (int i = 0; i <= nx; ++i) mesh.vertices.row(j * (nx + 1) + i) << width * i / nx, height * j / ny, 0;
  mesh.triangles.resize(2 * nx * ny, 3);
  for (int j = 0, t = 0; j < ny; ++j)
    for (int i = 0; i < nx; ++i) {
      const int a = j * (nx + 1) + i, b = a + 1, c = b + nx + 1, d = a + nx + 1;
      mesh.triangles.row(t++) << a, b, c;
      mesh.triangles.row(t++) << a, c, d;
    }
  return mesh;
}

SurfaceMesh crossed_grid(int nx, int ny, double width, double height) {
  require_indexable(2.0 * nx * ny);
  const SurfaceMesh corners = grid(nx, ny, width, height);
  const auto first = static_cast<int>(corners.vertices.rows());
  SurfaceMesh mesh;
  mesh.vertices.resize(first + nx * ny, 3);
  mesh.vertices.topRows(first) = corners.vertices;
  mesh.triangles.resize(4 * nx * ny, 3);
  for (int j = 0, t = 0; j < ny; ++j)
    for (int i = 0; i < nx; ++i) {
      const int a = j * (nx + 1) + i, b = a + 1, c = b + nx + 1, d = a + nx + 1, m = first + j * nx + i;
      mesh.vertices.row(m) << width * (i + 0.5) / nx, height * (j + 0.5) / ny, 0;
      mesh.triangles.row(t++) << a, b, m;
      mesh.triangles.row(t++) << b, c, m;
      mesh.triangles.row(t++) << c, d, m;
      mesh.triangles.row(t++) << d, a, m;
    }
  return mesh;
}

SurfaceMesh disc(int rings) {
  require_count("rings", rings);
  require_indexable(6.0 * rings * rings);
  SurfaceMesh mesh;
  mesh.vertices.setZero(ring_start(rings + 1), 3);
  for (int k = 1; k <= rings; ++k)
    for (int i = 0; i < 6 * k; ++i) {
      const double radius = double(k) / rings, angle = 2 * pi * i / (6 * k);
      mesh.vertices.row(ring_vertex(k, i)) << radius * std::cos(angle), radius * std::sin(angle), 0;
    }
  mesh.triangles.resize(6 * rings * rings, 3);
  int t = 0;
  for (int k = 0; k < rings; ++k)
    for (int sector = 0; sector < 6; ++sector) append_sector(mesh.triangles, t, k, sector);
  return mesh;
}

SurfaceMesh icosphere(int level) {
  require_count("level", level, 0);
  require_indexable(20 * std::pow(4.0, level));
  SurfaceMesh mesh = icosahedron();
  for (int i = 0; i < level; ++i) mesh = subdivide(mesh);
  return mesh;
}

SurfaceMesh procedural_face(int rings) {
  SurfaceMesh mesh = disc(rings);
  for (Eigen::Index i = 0; i < mesh.vertices.rows(); ++i) {
    const double x = mesh.vertices(i, 0), y = mesh.vertices(i, 1), r = std::hypot(x, y);
    const double polar = 0.72 * pi * r;  // from the tip of the nose: the cap reaches behind the ears
    const double s = r > 0 ? std::sin(polar) / r : 0.72 * pi;
    const double radius = 1 + face_relief(x, y);
    mesh.vertices.row(i) << 0.8 * radius * s * x, 1.1 * radius * s * y, 0.9 * radius * std::cos(polar);
  }
  return mesh;
}

}  // namespace isostretch::mesh
