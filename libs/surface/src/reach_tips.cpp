#include "cut_graph.hpp"
#include "generic_weights.hpp"
#include "shortest_paths.hpp"

#include <isostretch/core/error.hpp>
#include <isostretch/core/index.hpp>
#include <isostretch/mesh/measure.hpp>
#include <isostretch/sparse/solver.hpp>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

namespace isostretch::mesh {
namespace {

// How much curvature the surface has at each vertex, and how strongly neighbours are coupled: what the
// logarithm of the scale of a conformal map to the plane follows from, by one linear equation.
class Curvature {
 public:
  Curvature(const Piece& piece, const Points3& vertices)
      : surface_(piece.surface),
        defect_(surface_.outgoing.size(), 2 * std::numbers::pi),
        coupling_(at(surface_.count()), 0) {
    for (int h = 0; h < surface_.count(); ++h) add_corner(vertices, h);
    for (double& weight : coupling_) weight = std::clamp(weight, least_coupling, 1 / least_coupling);
  }

  // The logarithm of the scale that is zero at the vertices on the cut (Ben-Chen, Gotsman & Bunin, "Conformal
  // flattening by curvature prescription and metric scaling", 2008).
  std::vector<double> scale(const std::vector<char>& on_cut) const {
    std::vector<int> unknown(on_cut.size(), -1), vertex_of;
    for (std::size_t v = 0; v < on_cut.size(); ++v)
      if (!on_cut[v]) {
        unknown[v] = static_cast<int>(vertex_of.size());
        vertex_of.push_back(static_cast<int>(v));
      }
    std::vector<double> result(on_cut.size(), 0.0);
    if (vertex_of.empty()) return result;
    const sparse::SymmetricMatrix matrix = laplacian(unknown, vertex_of);
    const std::unique_ptr<sparse::Solver> solver = sparse::make_solver({});
    solver->analyze(matrix);
    std::vector<double> b, x(vertex_of.size());
    for (const int v : vertex_of) b.push_back(defect_[at(v)]);
    const sparse::FactorResult factored = solver->factorize(matrix);
    if (!factored) throw Error("cannot see how the surface is curved: " + factored.message);
    const sparse::SolveResult solved = solver->solve_columns(b.data(), x.data(), 1);
    if (!solved) throw Error("cannot see how the surface is curved: " + solved.message);
    for (std::size_t i = 0; i < x.size(); ++i) result[at(vertex_of[i])] = x[i];
    return result;
  }

 private:
  static constexpr double least_coupling = 1e-3;

  // The corner opposite to the half-edge.
  void add_corner(const Points3& vertices, int h) {
    const int a = surface_.from(h), b = surface_.to(h), apex = surface_.from(HalfEdges::previous(h));
    const Vector3 to_a = edge_vector(vertices, apex, a), to_b = edge_vector(vertices, apex, b);
    const double sine = length(cross(to_a, to_b)), cosine = dot(to_a, to_b);
    defect_[at(apex)] -= std::atan2(sine, cosine);
    const double half_cotangent = sine > 0 ? 0.5 * cosine / sine : 0;
    coupling_[at(h)] += half_cotangent;
    if (!surface_.on_boundary(h)) coupling_[at(surface_.opposite[at(h)])] += half_cotangent;
  }

  sparse::SymmetricMatrix laplacian(const std::vector<int>& unknown,
                                    const std::vector<int>& vertex_of) const {
    sparse::SymmetricMatrix matrix;
    matrix.size = static_cast<int>(vertex_of.size());
    matrix.column_start.push_back(0);
    std::vector<std::pair<int, double>> column;
    for (int i = 0; i < matrix.size; ++i) {
      double diagonal = 0;
      column.clear();
      for_each_neighbour(surface_, vertex_of[at(i)], [&](int h, int neighbour) {
        diagonal += coupling_[at(h)];
        if (unknown[at(neighbour)] > i) column.emplace_back(unknown[at(neighbour)], -coupling_[at(h)]);
      });
      column.emplace_back(i, diagonal);
      std::sort(column.begin(), column.end());
      for (const auto& [row, value] : column) {
        matrix.row.push_back(row);
        matrix.value.push_back(value);
      }
      matrix.column_start.push_back(matrix.nonzeros());
    }
    return matrix;
  }

  const HalfEdges& surface_;
  std::vector<double> defect_;
  std::vector<double> coupling_;
};

std::vector<char> vertices_on_cut(const Piece& piece, const EdgeMarks& marks) {
  std::vector<char> on_cut(piece.surface.outgoing.size(), 0);
  for (int h = 0; h < piece.surface.count(); ++h)
    if (marks[at(h)] || piece.surface.on_boundary(h))
      on_cut[at(piece.surface.from(h))] = on_cut[at(piece.surface.to(h))] = 1;
  return on_cut;
}

}  // namespace

void reach_tips(const Piece& piece, const Points3& vertices, int most, double least_scale, EdgeMarks& marks) {
  const Curvature curvature(piece, vertices);
  const GenericFunction generic(vertices);
  std::vector<char> on_cut = vertices_on_cut(piece, marks);
  for (int tips = 0; tips < most; ++tips) {
    const std::vector<double> scale = curvature.scale(on_cut);
    int worst = -1;
    double highest = least_scale;
    for (std::size_t v = 0; v < scale.size(); ++v) {
      const auto r = static_cast<Eigen::Index>(v);
      const double score =
          std::abs(scale[v]) * (1 + 0.02 * generic(vertices(r, 0), vertices(r, 1), vertices(r, 2)));
      if (score > highest) highest = score, worst = static_cast<int>(v);
    }
    if (worst < 0) return;
    const ShortestPaths paths = shortest_paths(piece.surface, piece.weights, {worst},
                                               [&](int v, double) { return on_cut[at(v)] != 0; });
    for (const int h : paths.path(piece.surface, paths.last)) {
      mark(piece.surface, marks, h);
      on_cut[at(piece.surface.from(h))] = on_cut[at(piece.surface.to(h))] = 1;
    }
  }
}

}  // namespace isostretch::mesh
