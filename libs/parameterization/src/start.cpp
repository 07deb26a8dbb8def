#include "affine_fit.hpp"

#include <isostretch/parameterization/start.hpp>
#include <isostretch/surface/boundary.hpp>
#include <isostretch/surface/orientation.hpp>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <utility>

namespace isostretch::parameterization {
namespace {

std::vector<int> boundary_vertices(const mesh::SurfaceMesh& chart) {
  std::vector<int> all;
  for (const auto& loop : mesh::boundary_loops(chart)) all.insert(all.end(), loop.begin(), loop.end());
  return all;
}

// Energies this many times their minimum are a long way down for a minimisation.
constexpr double far_up = 1e6;

bool far_off(const mesh::ElementArrays& rest, const StartResult& start) {
  return !(stretch_energy(rest, start.uv) < far_up * 4 * mesh::total_weight(rest));
}

// Tutte's embedding; its uv is empty when the linear solver failed.
StartResult embed(const mesh::SurfaceMesh& disk, const mesh::SurfaceMesh& chart,
                  const mesh::ElementArrays& rest, const parameterization::TutteOptions& options) {
  parameterization::TutteResult embedding = parameterization::tutte_embedding(disk, options);
  StartResult start;
  start.message = embedding.message;
  start.reweightings = embedding.reweightings;
  if (embedding.status == parameterization::TutteStatus::failed) return start;
  start.uv = embedding.uv.topRows(chart.vertices.rows());
  const mesh::OrientationReport orientation = mesh::orientation(start.uv, chart.triangles);
  start.uv *= std::sqrt(mesh::total_weight(rest) / orientation.total_area);
  start.flipped = orientation.flipped;
  start.method = embedding.reweightings > 0 || options.weights != parameterization::EdgeWeights::uniform
                     ? StartMethod::weighted
                     : StartMethod::uniform;
  return start;
}

// Fewer flips, then less energy.
bool better(const mesh::ElementArrays& rest, const StartResult& a, const StartResult& b) {
  if (a.uv.rows() == 0 || b.uv.rows() == 0) return b.uv.rows() == 0;
  if (a.flipped.size() != b.flipped.size()) return a.flipped.size() < b.flipped.size();
  return stretch_energy(rest, a.uv) < stretch_energy(rest, b.uv);
}

// The chart seen along its mean normal: isometric when it is flat, and worth a look when all else is far off.
StartResult projection(const mesh::SurfaceMesh& chart, const mesh::ElementArrays& rest) {
  using Vector3 = Eigen::Matrix<double, 1, 3>;
  const auto& p = chart.vertices;
  Vector3 normal = Vector3::Zero(), longest = Vector3::Zero();
  for (Eigen::Index t = 0; t < chart.triangles.rows(); ++t) {
    const Vector3 a = p.row(chart.triangles(t, 1)) - p.row(chart.triangles(t, 0));
    const Vector3 b = p.row(chart.triangles(t, 2)) - p.row(chart.triangles(t, 0));
    normal += a.cross(b);
    if (a.squaredNorm() > longest.squaredNorm()) longest = a;
  }
  const Vector3 n = normal.normalized(), u = (longest - longest.dot(n) * n).normalized(), v = n.cross(u);
  StartResult start;
  start.method = StartMethod::weighted;
  start.uv.resize(p.rows(), 2);
  for (Eigen::Index i = 0; i < p.rows(); ++i) {
    const Vector3 r = p.row(i) - p.row(0);
    start.uv.row(i) << r.dot(u), r.dot(v);
  }
  const mesh::OrientationReport orientation = mesh::orientation(start.uv, chart.triangles);
  start.uv *= std::sqrt(mesh::total_weight(rest) / std::abs(orientation.total_area));
  start.flipped = orientation.flipped;
  if (!start.uv.allFinite()) start.uv.resize(0, 2);
  return start;
}

// The start of an ordinary chart stays Tutte's embedding with uniform weights, as others have it; one that is
// far off is improved by what is cheap.
StartResult best_embedding(const mesh::SurfaceMesh& chart, const mesh::ElementArrays& rest,
                           const StartOptions& options) {
  const mesh::SurfaceMesh disk = parameterization::fill_holes(chart);
  parameterization::TutteOptions how = options.tutte;
  StartResult best = embed(disk, chart, rest, how);
  if (best.uv.rows() > 0 && !far_off(rest, best)) return best;
  how.weights = parameterization::EdgeWeights::cotangent;
  StartResult other = embed(disk, chart, rest, how);
  if (!options.keep_boundary) {
    for (StartResult* start : {&best, &other})
      if (start->uv.rows() > 0 && start->flipped.empty()) fit_affinely(rest, start->uv);
    StartResult flat = projection(chart, rest);
    if (better(rest, flat, other)) other = std::move(flat);
  }
  return better(rest, other, best) ? other : best;
}

// Keeps what there was unless untangling made it better.
void untangle_start(const mesh::SurfaceMesh& chart, const mesh::ElementArrays& rest,
                    const StartOptions& options, StartResult& start) {
  UntangleOptions how = options.untangle;
  how.stop = options.stop;
  how.min_determinant = std::max(how.min_determinant, 1e-3);
  const std::vector<int> pinned = options.keep_boundary ? boundary_vertices(chart) : std::vector<int>();
  Vector x = Eigen::Map<const Vector>(start.uv.data(), start.uv.size());
  StartResult untangled = start;
  untangled.untangling = untangle(assembly::elements_from(rest), x, how, pinned);
  untangled.method = StartMethod::untangled;
  untangled.uv = Eigen::Map<const mesh::Points2>(x.data(), start.uv.rows(), 2);
  untangled.flipped = mesh::orientation(untangled.uv, chart.triangles).flipped;
  if (better(rest, untangled, start)) start = std::move(untangled);
}

}  // namespace

std::string_view start_method_name(StartMethod method) noexcept {
  switch (method) {
    case StartMethod::uniform:
      return "uniform";
    case StartMethod::weighted:
      return "weighted";
    case StartMethod::untangled:
      return "untangled";
  }
  return "";
}

StartResult flip_free_start(const mesh::SurfaceMesh& chart, const mesh::ElementArrays& rest,
                            const StartOptions& options) {
  StartResult start = best_embedding(chart, rest, options);
  if (start.uv.rows() == 0) return start;
  if (far_off(rest, start)) untangle_start(chart, rest, options, start);
  if (start.flipped.empty()) start.message.clear();
  return start;
}

}  // namespace isostretch::parameterization
