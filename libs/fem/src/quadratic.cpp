#include "simplex_edges.hpp"

#include <isostretch/fem/quadratic.hpp>
#include <isostretch/mesh/require.hpp>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <unordered_map>
#include <utility>
#include <vector>

namespace isostretch::mesh {
namespace {

// Numbers edges from `first` in the order in which they are first asked for.
class EdgeNodes {
 public:
  explicit EdgeNodes(Eigen::Index first) : first_(first) {}

  int of(int a, int b) {
    const auto [low, high] = std::minmax(a, b);
    const auto key = static_cast<std::uint64_t>(low) << 32 | static_cast<std::uint64_t>(high);
    const auto next = first_ + static_cast<Eigen::Index>(ends_.size());
    const auto [entry, is_new] = number_.emplace(key, static_cast<int>(next));
    if (is_new && next >= std::numeric_limits<int>::max()) throw Error("the mesh has too many edges");
    if (is_new) ends_.emplace_back(low, high);
    return entry->second;
  }

  const std::vector<std::pair<int, int>>& ends() const { return ends_; }

 private:
  Eigen::Index first_;
  std::unordered_map<std::uint64_t, int> number_;
  std::vector<std::pair<int, int>> ends_;
};

template <int Dim, class Cells, class QuadraticCells>
EdgeNodes number_edges(const Cells& cells, Eigen::Index vertex_count, QuadraticCells& result) {
  EdgeNodes edges(vertex_count);
  result.resize(cells.rows(), QuadraticCells::ColsAtCompileTime);
  for (Eigen::Index t = 0; t < cells.rows(); ++t) {
    for (int a = 0; a <= Dim; ++a) result(t, a) = cells(t, a);
    for (int e = 0; e < simplex_edge_count<Dim>; ++e)
      result(t, Dim + 1 + e) = edges.of(cells(t, simplex_edges[e][0]), cells(t, simplex_edges[e][1]));
  }
  return edges;
}

template <class Points>
Points with_midpoints(const Points& vertices, const std::vector<std::pair<int, int>>& ends) {
  Points nodes(vertices.rows() + static_cast<Eigen::Index>(ends.size()), vertices.cols());
  nodes.topRows(vertices.rows()) = vertices;
  Eigen::Index next = vertices.rows();
  for (const auto& [a, b] : ends) nodes.row(next++) = 0.5 * vertices.row(a) + 0.5 * vertices.row(b);
  return nodes;
}

}  // namespace

QuadraticTriangleMesh quadratic(const Points2& vertices, const Triangles& triangles) {
  require_indices(triangles, vertices.rows(), "triangle");
  QuadraticTriangleMesh result;
  const EdgeNodes edges = number_edges<2>(triangles, vertices.rows(), result.triangles);
  result.nodes = with_midpoints(vertices, edges.ends());
  return result;
}

QuadraticTetMesh quadratic(const TetMesh& mesh) {
  require_indices(mesh.tets, mesh.vertices.rows(), "tet");
  QuadraticTetMesh result;
  const EdgeNodes edges = number_edges<3>(mesh.tets, mesh.vertices.rows(), result.tets);
  result.nodes = with_midpoints(mesh.vertices, edges.ends());
  return result;
}

}  // namespace isostretch::mesh
