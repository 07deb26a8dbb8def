#include "plane_triangles.hpp"

#include <isostretch/mesh/require.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace isostretch::mesh {
namespace {

struct Keyed {
  unsigned long long code = 0;
  std::array<PlanePoint, 3> corner{};
  int triangle = 0;

  bool operator<(const Keyed& other) const {
    if (code != other.code) return code < other.code;
    return corner != other.corner ? corner < other.corner : triangle < other.triangle;
  }
};

double size_of(const Points2& uv) {
  const double largest = uv.rows() > 0 ? uv.cwiseAbs().maxCoeff() : 0;
  return largest > 0 ? std::ldexp(1.0, std::ilogb(largest)) : 1;
}

PlaneBox box_of(const std::array<PlanePoint, 3>& corner) {
  PlaneBox box{corner[0], corner[0]};
  for (const PlanePoint& p : corner) box.include({p, p});
  return box;
}

// Whether the line through an edge of a has b on its right.
bool separates(const PlaneTriangle& a, const PlaneTriangle& b) {
  for (std::size_t e = 0; e < 3; ++e) {
    const PlanePoint &from = a.corner[e], &to = a.corner[(e + 1) % 3];
    if (side(from, to, b.corner[0]) <= 0 && side(from, to, b.corner[1]) <= 0 &&
        side(from, to, b.corner[2]) <= 0)
      return true;
  }
  return false;
}

// Those with an area, counter-clockwise. Adding zero makes one zero of two.
std::vector<Keyed> upright(const Points2& uv, const Triangles& mesh, double unit) {
  std::vector<Keyed> all;
  all.reserve(static_cast<std::size_t>(mesh.rows()));
  for (Eigen::Index t = 0; t < mesh.rows(); ++t) {
    Keyed key;
    key.triangle = static_cast<int>(t);
    for (std::size_t c = 0; c < 3; ++c)
      for (std::size_t d = 0; d < 2; ++d)
        key.corner[c][d] =
            uv(mesh(t, static_cast<Eigen::Index>(c)), static_cast<Eigen::Index>(d)) / unit + 0.0;
    const int turn = side(key.corner[0], key.corner[1], key.corner[2]);
    if (turn == 0) continue;
    if (turn < 0) std::swap(key.corner[1], key.corner[2]);
    std::rotate(key.corner.begin(), std::min_element(key.corner.begin(), key.corner.end()), key.corner.end());
    all.push_back(key);
  }
  return all;
}

void sort_along_curve(std::vector<Keyed>& all) {
  if (all.empty()) return;
  PlaneBox whole = box_of(all.front().corner);
  for (const Keyed& key : all) whole.include(box_of(key.corner));
  for (Keyed& key : all) {
    const PlaneBox box = box_of(key.corner);
    key.code = morton_code({0.5 * (box.low[0] + box.high[0]), 0.5 * (box.low[1] + box.high[1])}, whole);
  }
  std::sort(all.begin(), all.end());
}

}  // namespace

PlaneBox PlaneTriangle::box() const {
  return box_of(corner);
}

PlaneTriangles::PlaneTriangles(const Points2& uv, const Triangles& mesh) {
  require_finite(uv, "point");
  require_indices(mesh, uv.rows(), "triangle");
  unit = size_of(uv);
  std::vector<Keyed> all = upright(uv, mesh, unit);
  sort_along_curve(all);
  for (const Keyed& key : all) {
    if (triangles.empty() || triangles.back().corner != key.corner) triangles.push_back({key.corner, {}});
    triangles.back().copies.push_back(key.triangle);
  }
}

// Of two convex polygons whose interiors are apart, an edge of one separates them.
bool interiors_meet(const PlaneTriangle& a, const PlaneTriangle& b) {
  return !separates(a, b) && !separates(b, a);
}

}  // namespace isostretch::mesh
