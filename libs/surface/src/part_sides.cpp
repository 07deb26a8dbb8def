
#include "exact_side.hpp"

#include <isostretch/core/index.hpp>
#include <isostretch/surface/overlap.hpp>
#include <isostretch/surface/topology.hpp>

#include <algorithm>

namespace isostretch::mesh {
namespace {

std::vector<char> vertices_that_overlap(const Points2& uv, const Triangles& triangles) {
  std::vector<char> concerned(static_cast<std::size_t>(uv.rows()), 0);
  for (const int t : find_overlap(uv, triangles).triangles)
    for (const int v : triangles.row(t)) concerned[at(v)] = 1;
  return concerned;
}

// Sums of the unit normals of the boundary edges at each vertex, to the left; zero inside.
Points2 inward(const Points2& uv, const Triangles& triangles) {
  Points2 sum = Points2::Zero(uv.rows(), 2);
  for_each_edge(sorted_sides(triangles), [&](const Side* begin, const Side* end) {
    if (end - begin != 1) return;
    const Eigen::RowVector2d along = uv.row(begin->to()) - uv.row(begin->from());
    const double length = along.norm();
    if (!(length > 0)) return;
    for (const int v : {begin->low, begin->high})
      sum.row(v) += Eigen::RowVector2d(-along.y(), along.x()) / length;
  });
  return sum;
}

int turn(const Points2& uv, const Triangles& triangles, Eigen::Index t) {
  const auto point = [&](int c) { return PlanePoint{uv(triangles(t, c), 0), uv(triangles(t, c), 1)}; };
  return side(point(0), point(1), point(2));
}

// Puts vertices back until every triangle has the orientation it had.
void undo_flips(const Points2& before, const Triangles& triangles, Points2& uv) {
  for (bool changed = true; changed;) {
    changed = false;
    for (Eigen::Index t = 0; t < triangles.rows(); ++t) {
      if (turn(uv, triangles, t) == turn(before, triangles, t)) continue;
      for (const int v : triangles.row(t)) uv.row(v) = before.row(v);
      changed = true;
    }
  }
}

}  // namespace

int part_sides(Points2& uv, const Triangles& triangles, double distance) {
  constexpr double least_normal = 0.1;  // less: an end of a cut, which has no side to move to
  const Points2 before = uv;
  const std::vector<char> concerned = vertices_that_overlap(uv, triangles);
  const Points2 normal = inward(uv, triangles);
  for (Eigen::Index v = 0; v < uv.rows(); ++v)
    if (concerned[static_cast<std::size_t>(v)] && normal.row(v).norm() > least_normal)
      uv.row(v) += distance * normal.row(v).normalized();
  undo_flips(before, triangles, uv);
  int moved = 0;
  for (Eigen::Index v = 0; v < uv.rows(); ++v) moved += uv.row(v) != before.row(v);
  return moved;
}

}  // namespace isostretch::mesh
