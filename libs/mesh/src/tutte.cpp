#include "measure.hpp"
#include "require.hpp"
#include "topology.hpp"

#include <isostretch/mesh/boundary.hpp>
#include <isostretch/mesh/check.hpp>
#include <isostretch/mesh/orientation.hpp>
#include <isostretch/mesh/tutte.hpp>
#include <isostretch/sparse/solver.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace isostretch::mesh {
namespace {

// Places the loop counter-clockwise on the circle around the origin whose inscribed polygon has area 1.
void place_boundary(const Points3& vertices, const std::vector<int>& loop, Points2& uv) {
  const std::size_t n = loop.size();
  std::vector<double> spacing(n);
  double total = 0;
  for (std::size_t i = 0; i < n; ++i) {
    spacing[i] = length(edge_vector(vertices, loop[i], loop[(i + 1) % n]));
    total += spacing[i];
  }
  // Vertices that coincide in space must not coincide on the circle, nor may one edge take half of it.
  const double even = 1.0 / static_cast<double>(n);
  double sum = 0;
  for (double& s : spacing) {
    s = total > 0 ? std::clamp(s / total, 1e-6 * even, 0.4) : even;
    sum += s;
  }
  double twice_area = 0, angle = 0;
  for (std::size_t i = 0; i < n; ++i) {
    uv.row(loop[i]) << std::cos(angle), std::sin(angle);
    const double step = 2 * std::numbers::pi * spacing[i] / sum;
    twice_area += std::sin(step);
    angle += step;
  }
  const double radius = 1 / std::sqrt(0.5 * twice_area);
  for (const int vertex : loop) uv.row(vertex) *= radius;
}

// The Laplacian of the interior vertices with unit weights; boundary vertices go to the right-hand side.
class InteriorLaplacian {
 public:
  InteriorLaplacian(const Triangles& triangles, const std::vector<int>& boundary, int vertex_count)
      : unknown_(static_cast<std::size_t>(vertex_count), 0) {
    for (const int vertex : boundary) unknown_[static_cast<std::size_t>(vertex)] = -1;
    for (int v = 0; v < vertex_count; ++v)
      if (unknown(v) == 0) {
        unknown_[static_cast<std::size_t>(v)] = static_cast<int>(vertex_of_.size());
        vertex_of_.push_back(v);
      }
    for_each_edge(sorted_sides(triangles), [&](const Side* begin, const Side*) {
      edges_.push_back({begin->low, begin->high});
    });
    assemble();
  }

  const sparse::SymmetricMatrix& matrix() const { return matrix_; }
  const std::vector<int>& vertex_of() const { return vertex_of_; }

  // Sum of the boundary neighbours: u of all unknowns, then v.
  std::vector<double> right_hand_side(const Points2& uv) const {
    std::vector<double> b(2 * vertex_of_.size(), 0.0);
    const auto add_neighbour = [&](int inner, int outer) {
      if (unknown(inner) < 0 || unknown(outer) >= 0) return;
      for (int d = 0; d < 2; ++d)
        b[static_cast<std::size_t>(d * matrix_.size + unknown(inner))] += uv(outer, d);
    };
    for (const auto& [i, j] : edges_) {
      add_neighbour(i, j);
      add_neighbour(j, i);
    }
    return b;
  }

 private:
  int unknown(int vertex) const { return unknown_[static_cast<std::size_t>(vertex)]; }

  // Edges are sorted by their lower vertex, then the higher, and unknowns ascend with vertices: so do the
  // entries.
  void assemble() {
    std::vector<double> degree(vertex_of_.size(), 0.0);
    for (const auto& [i, j] : edges_)
      for (const int v : {i, j})
        if (unknown(v) >= 0) ++degree[static_cast<std::size_t>(unknown(v))];
    matrix_.size = static_cast<int>(vertex_of_.size());
    matrix_.column_start.push_back(0);
    auto edge = edges_.begin();
    for (int column = 0; column < matrix_.size; ++column) {
      const int vertex = vertex_of_[static_cast<std::size_t>(column)];
      add(column, degree[static_cast<std::size_t>(column)]);
      while (edge != edges_.end() && edge->first < vertex) ++edge;
      for (; edge != edges_.end() && edge->first == vertex; ++edge)
        if (unknown(edge->second) >= 0) add(unknown(edge->second), -1.0);
      matrix_.column_start.push_back(matrix_.nonzeros());
    }
  }

  void add(int row, double value) {
    matrix_.row.push_back(row);
    matrix_.value.push_back(value);
  }

  std::vector<int> unknown_;    // vertex -> unknown, -1 on the boundary
  std::vector<int> vertex_of_;  // unknown -> vertex
  std::vector<std::pair<int, int>> edges_;
  sparse::SymmetricMatrix matrix_;
};

// Empty when all is well.
std::string solve_interior(const InteriorLaplacian& laplacian, const sparse::Options& options, Points2& uv) {
  const auto solver = sparse::make_solver(options);
  solver->analyze(laplacian.matrix());
  const sparse::FactorResult factored = solver->factorize(laplacian.matrix());
  if (!factored) return factored.message;
  const std::vector<double> b = laplacian.right_hand_side(uv);
  std::vector<double> x(b.size());
  const sparse::SolveResult solved = solver->solve_columns(b.data(), x.data(), 2);
  if (!solved) return solved.message;
  const std::size_t n = laplacian.vertex_of().size();
  for (std::size_t i = 0; i < n; ++i) uv.row(laplacian.vertex_of()[i]) << x[i], x[n + i];
  return {};
}

void report_flips(const Triangles& triangles, TutteResult& result) {
  OrientationReport report = orientation(result.uv, triangles);
  if (report.flipped.empty()) return;
  result.status = TutteStatus::flipped;
  result.flipped = std::move(report.flipped);
  result.message = "Tutte embedding: " + std::to_string(result.flipped.size()) +
                   " triangles are not positively oriented, first " +
                   element_text("triangle", triangles, result.flipped.front());
}

}  // namespace

TutteResult tutte_embedding(const SurfaceMesh& mesh, const TutteOptions& options) {
  require_disk(mesh);
  const std::vector<int> loop = boundary_loops(mesh).front();
  TutteResult result;
  result.uv.setZero(mesh.vertices.rows(), 2);
  place_boundary(mesh.vertices, loop, result.uv);
  const InteriorLaplacian laplacian(mesh.triangles, loop, static_cast<int>(mesh.vertices.rows()));
  const std::string fault = solve_interior(laplacian, options.solver, result.uv);
  if (!fault.empty()) return {TutteStatus::failed, "Tutte embedding: " + fault, {}, {}};
  report_flips(mesh.triangles, result);
  return result;
}

}  // namespace isostretch::mesh
