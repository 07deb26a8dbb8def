#include "further_cut.hpp"

#include <isostretch/mesh/boundary.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace isostretch::app::parameterize {
namespace {

double distortion_of(const std::vector<double>& stretches, std::size_t triangle) {
  const double largest = stretches[2 * triangle], smallest = stretches[2 * triangle + 1];
  return smallest > 0 ? std::max(largest, 1 / smallest) : HUGE_VAL;
}

// Of the triangles around every vertex, weighted by their areas in space.
std::vector<double> mean_around(const mesh::SurfaceMesh& mesh, const std::vector<double>& stretches) {
  std::vector<double> sum(static_cast<std::size_t>(mesh.vertices.rows()), 0.0), count = sum;
  for (Eigen::Index t = 0; t < mesh.triangles.rows(); ++t)
    for (int c = 0; c < 3; ++c) {
      const auto v = static_cast<std::size_t>(mesh.triangles(t, c));
      sum[v] += std::log(distortion_of(stretches, static_cast<std::size_t>(t)));
      count[v] += 1;
    }
  for (std::size_t v = 0; v < sum.size(); ++v) sum[v] /= std::max(count[v], 1.0);
  return sum;
}

}  // namespace

double worst_distortion(const std::vector<double>& stretches) {
  double worst = 1;
  for (std::size_t t = 0; 2 * t < stretches.size(); ++t) worst = std::max(worst, distortion_of(stretches, t));
  return worst;
}

int worst_vertex(const Domain& domain, const std::vector<double>& stretches, double bound) {
  const mesh::SurfaceMesh& open = domain.open();
  std::vector<bool> on_boundary(static_cast<std::size_t>(open.vertices.rows()), false);
  for (const auto& loop : mesh::boundary_loops(open))
    for (const int v : loop) on_boundary[static_cast<std::size_t>(v)] = true;
  double worst = bound;
  Eigen::Index triangle = -1;
  for (Eigen::Index t = 0; t < open.triangles.rows(); ++t) {
    bool inside = false;
    for (int c = 0; c < 3; ++c) inside = inside || !on_boundary[static_cast<std::size_t>(open.triangles(t, c))];
    const double own = distortion_of(stretches, static_cast<std::size_t>(t));
    if (inside && own > worst) worst = own, triangle = t;
  }
  if (triangle < 0) return -1;
  const std::vector<double> mean = mean_around(open, stretches);
  int best = -1;
  for (int c = 0; c < 3; ++c) {
    const int v = open.triangles(triangle, c);
    if (!on_boundary[static_cast<std::size_t>(v)] &&
        (best < 0 || mean[static_cast<std::size_t>(v)] > mean[static_cast<std::size_t>(best)]))
      best = v;
  }
  return best;
}

int cut_at(Domain& domain, int vertex, mesh::Points2& uv) {
  const std::vector<int> before = mesh::extend_cut(domain.cut, vertex);
  mesh::Points2 carried(static_cast<Eigen::Index>(before.size()), 2);
  for (std::size_t v = 0; v < before.size(); ++v) carried.row(static_cast<Eigen::Index>(v)) = uv.row(before[v]);
  uv = carried;
  const mesh::Triangles& triangles = domain.open().triangles;
  for (Eigen::Index t = 0; t < triangles.rows(); ++t)
    for (int c = 0; c < 3; ++c)
      if (triangles(t, c) == vertex) return domain.cut.chart[static_cast<std::size_t>(t)];
  throw Error("vertex " + std::to_string(vertex) + " is in no triangle of the cut mesh");
}

}  // namespace isostretch::app::parameterize
