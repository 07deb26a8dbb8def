#include "boundary_shape.hpp"

#include <isostretch/fem/element_arrays.hpp>
#include <isostretch/mesh/measure.hpp>
#include <isostretch/mesh/require.hpp>
#include <isostretch/parameterization/tutte.hpp>
#include <isostretch/sparse/solver.hpp>
#include <isostretch/surface/boundary.hpp>
#include <isostretch/surface/check.hpp>
#include <isostretch/surface/orientation.hpp>
#include <isostretch/surface/topology.hpp>

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

namespace isostretch::parameterization {
namespace {

// Cotangent of the angle of a triangle across the edge between two of its vertices; 0 of one without area.
double opposite_cotangent(const mesh::SurfaceMesh& mesh, int triangle, int from, int to) {
  const auto corners = mesh.triangles.row(triangle);
  int apex = corners[0];
  for (const int v : corners)
    if (v != from && v != to) apex = v;
  const mesh::Vector3 a = mesh::edge_vector(mesh.vertices, apex, from),
                      b = mesh::edge_vector(mesh.vertices, apex, to);
  const double twice_area = mesh::length(mesh::cross(a, b));
  return twice_area > 0 ? mesh::dot(a, b) / twice_area : 0.0;
}

// The weighted Laplacian of the interior vertices; boundary vertices go to the right-hand side.
class InteriorLaplacian {
 public:
  InteriorLaplacian(const mesh::Triangles& triangles, const std::vector<int>& boundary, int vertex_count)
      : unknown_(static_cast<std::size_t>(vertex_count), 0) {
    for (const int vertex : boundary) unknown_[static_cast<std::size_t>(vertex)] = -1;
    for (int v = 0; v < vertex_count; ++v)
      if (unknown(v) == 0) {
        unknown_[static_cast<std::size_t>(v)] = static_cast<int>(vertex_of_.size());
        vertex_of_.push_back(v);
      }
    mesh::for_each_edge(mesh::sorted_sides(triangles), [&](const mesh::Side* begin, const mesh::Side* end) {
      edges_.push_back({begin->low, begin->high, begin->triangle, (end - 1)->triangle});
    });
    assemble();
  }

  // Sum of the cotangents of the angles opposite, from the triangles in space.
  void weigh_by_cotangents(const mesh::SurfaceMesh& mesh) {
    constexpr double least = 1e-3;  // angles across that are obtuse together would pull the other way
    for (WeightedEdge& e : edges_) {
      double sum = 0;
      for (const int t : {e.left, e.right}) sum += opposite_cotangent(mesh, t, e.low, e.high);
      e.weight = std::max(0.5 * sum, least);
    }
    assemble();
  }

  // weight *= the mean of `factor` over the triangles at the edge.
  void reweight(const std::vector<double>& factor) {
    for (WeightedEdge& e : edges_)
      e.weight *=
          0.5 * (factor[static_cast<std::size_t>(e.left)] + factor[static_cast<std::size_t>(e.right)]);
    assemble();
  }

  const sparse::SymmetricMatrix& matrix() const { return matrix_; }
  const std::vector<int>& vertex_of() const { return vertex_of_; }

  // Weighted sum of the boundary neighbours: u of all unknowns, then v.
  std::vector<double> right_hand_side(const mesh::Points2& uv) const {
    std::vector<double> b(2 * vertex_of_.size(), 0.0);
    const auto add_neighbour = [&](int inner, int outer, double weight) {
      if (unknown(inner) < 0 || unknown(outer) >= 0) return;
      for (int d = 0; d < 2; ++d)
        b[static_cast<std::size_t>(d * matrix_.size + unknown(inner))] += weight * uv(outer, d);
    };
    for (const WeightedEdge& e : edges_) {
      add_neighbour(e.low, e.high, e.weight);
      add_neighbour(e.high, e.low, e.weight);
    }
    return b;
  }

 private:
  int unknown(int vertex) const { return unknown_[static_cast<std::size_t>(vertex)]; }

  struct WeightedEdge {
    int low, high;    // vertices
    int left, right;  // triangles; the same one on the boundary
    double weight = 1;
  };

  // Edges are sorted by their lower vertex, then the higher, and unknowns ascend with vertices: so do the
  // entries.
  void assemble() {
    std::vector<double> diagonal(vertex_of_.size(), 0.0);
    for (const WeightedEdge& e : edges_)
      for (const int v : {e.low, e.high})
        if (unknown(v) >= 0) diagonal[static_cast<std::size_t>(unknown(v))] += e.weight;
    matrix_ = {};
    matrix_.size = static_cast<int>(vertex_of_.size());
    matrix_.column_start.push_back(0);
    auto edge = edges_.begin();
    for (int column = 0; column < matrix_.size; ++column) {
      const int vertex = vertex_of_[static_cast<std::size_t>(column)];
      add(column, diagonal[static_cast<std::size_t>(column)]);
      while (edge != edges_.end() && edge->low < vertex) ++edge;
      for (; edge != edges_.end() && edge->low == vertex; ++edge)
        if (unknown(edge->high) >= 0) add(unknown(edge->high), -edge->weight);
      matrix_.column_start.push_back(matrix_.nonzeros());
    }
  }

  void add(int row, double value) {
    matrix_.row.push_back(row);
    matrix_.value.push_back(value);
  }

  std::vector<int> unknown_;    // vertex -> unknown, -1 on the boundary
  std::vector<int> vertex_of_;  // unknown -> vertex
  std::vector<WeightedEdge> edges_;
  sparse::SymmetricMatrix matrix_;
};

// Solves for the interior of uv; the pattern is analysed once.
class InteriorSolver {
 public:
  InteriorSolver(const InteriorLaplacian& laplacian, const sparse::Options& options)
      : laplacian_(laplacian), solver_(sparse::make_solver(options)) {
    solver_->analyze(laplacian.matrix());
  }

  // Empty when all is well.
  std::string solve(mesh::Points2& uv) {
    const sparse::FactorResult factored = solver_->factorize(laplacian_.matrix());
    if (!factored) return factored.message;
    const std::vector<double> b = laplacian_.right_hand_side(uv);
    std::vector<double> x(b.size());
    const sparse::SolveResult solved = solver_->solve_columns(b.data(), x.data(), 2);
    if (!solved) return solved.message;
    const std::size_t n = laplacian_.vertex_of().size();
    for (std::size_t i = 0; i < n; ++i) uv.row(laplacian_.vertex_of()[i]) << x[i], x[n + i];
    return {};
  }

 private:
  const InteriorLaplacian& laplacian_;
  std::unique_ptr<sparse::Solver> solver_;
};

// Length in uv over length in space, from the areas of each triangle, relative to that of the whole; bounded,
// so that a collapsed triangle changes a weight by no more than rounding lets uv be known.
std::vector<double> relative_scale(const mesh::SurfaceMesh& mesh, const mesh::Points2& uv) {
  std::vector<double> scale(static_cast<std::size_t>(mesh.triangles.rows()));
  const double typical = std::sqrt(1.0 / mesh::total_area(mesh));
  for (Eigen::Index t = 0; t < mesh.triangles.rows(); ++t) {
    const double rest = mesh::triangle_shape(mesh.vertices, mesh.triangles.row(t)).area();
    const double area = std::max(mesh::signed_area(uv, mesh.triangles.row(t)), 0.0);
    scale[static_cast<std::size_t>(t)] =
        rest > 0 ? std::clamp(std::sqrt(area / rest) / typical, 1e-6, 1e6) : 1;
  }
  return scale;
}

// The mean, over the surface, of area in space over area in uv, relative to the whole: 1 where areas are
// kept.
double collapse(const mesh::SurfaceMesh& mesh, const mesh::Points2& uv) {
  const double total = mesh::total_area(mesh);
  double sum = 0;
  for (Eigen::Index t = 0; t < mesh.triangles.rows(); ++t) {
    const double share = mesh::triangle_shape(mesh.vertices, mesh.triangles.row(t)).area() / total;
    sum += share * share / std::max(mesh::signed_area(uv, mesh.triangles.row(t)), 0.0);
  }
  return std::isnan(sum) ? HUGE_VAL : sum;  // 0 / 0 of a triangle without area
}

void report_flips(const mesh::Triangles& triangles, TutteResult& result) {
  if (result.flipped.empty()) return;
  result.status = TutteStatus::flipped;
  result.message = "Tutte embedding: " + std::to_string(result.flipped.size()) +
                   " triangles are not positively oriented, first " +
                   mesh::element_text("triangle", triangles, result.flipped.front());
}

}  // namespace

TutteResult tutte_embedding(const mesh::SurfaceMesh& mesh, const TutteOptions& options) {
  mesh::require_disk(mesh);
  const std::vector<int> loop = mesh::boundary_loops(mesh).front();
  TutteResult result;
  mesh::Points2 uv = mesh::Points2::Zero(mesh.vertices.rows(), 2);
  place_boundary(mesh.vertices, loop, options, uv);
  InteriorLaplacian laplacian(mesh.triangles, loop, static_cast<int>(mesh.vertices.rows()));
  if (options.weights == EdgeWeights::cotangent) laplacian.weigh_by_cotangents(mesh);
  InteriorSolver solver(laplacian, options.solver);
  double smallest_collapse = HUGE_VAL;
  for (int attempt = 0;; ++attempt) {
    const std::string fault = solver.solve(uv);
    if (!fault.empty() && attempt == 0) return {TutteStatus::failed, "Tutte embedding: " + fault, {}, {}, 0};
    if (!fault.empty()) break;  // weights beyond what the solver takes: the best so far is the result
    std::vector<int> flipped = mesh::orientation(uv, mesh.triangles).flipped;
    const double now = collapse(mesh, uv);
    const bool fewer = flipped.size() < result.flipped.size();
    const bool as_few = flipped.size() == result.flipped.size();
    if (attempt == 0 || fewer || (as_few && now < smallest_collapse)) {
      result.uv = uv;
      result.flipped = std::move(flipped);
      result.reweightings = attempt;
      smallest_collapse = now;
    }
    const bool good = result.flipped.empty() && smallest_collapse < options.acceptable_collapse;
    if (good || attempt == options.max_reweightings) break;
    laplacian.reweight(relative_scale(mesh, uv));
  }
  report_flips(mesh.triangles, result);
  return result;
}

}  // namespace isostretch::parameterization
