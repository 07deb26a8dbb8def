#include "orient.hpp"

#include <isostretch/core/index.hpp>
#include <isostretch/mesh/gather.hpp>
#include <isostretch/mesh/measure.hpp>
#include <isostretch/mesh/require.hpp>
#include <isostretch/surface/repair.hpp>

#include <algorithm>
#include <array>
#include <numeric>
#include <utility>

namespace isostretch::mesh {
namespace {

std::array<int, 3> ordered(const Triangles& triangles, int t) {
  std::array<int, 3> v = {triangles(t, 0), triangles(t, 1), triangles(t, 2)};
  std::sort(v.begin(), v.end());
  return v;
}

bool repeats_vertex(const Triangles& triangles, int t) {
  const auto v = ordered(triangles, t);
  return v[0] == v[1] || v[1] == v[2];
}

std::vector<int> degenerate_triangles(const Triangles& triangles) {
  std::vector<int> found;
  for (int t = 0; t < triangles.rows(); ++t)
    if (repeats_vertex(triangles, t)) found.push_back(t);
  return found;
}

std::vector<int> duplicate_triangles(const Triangles& triangles) {
  std::vector<std::pair<std::array<int, 3>, int>> keys;
  for (int t = 0; t < triangles.rows(); ++t) keys.emplace_back(ordered(triangles, t), t);
  std::sort(keys.begin(), keys.end());
  std::vector<int> found;
  for (std::size_t i = 1; i < keys.size(); ++i)
    if (keys[i].first == keys[i - 1].first) found.push_back(keys[i].second);
  std::sort(found.begin(), found.end());
  return found;
}

// Which of a piece's two orientations to keep: `area` and the others are sums over its triangles with the
// sign of the first orientation.
struct Votes {
  double area = 0, majority = 0;  // of all triangles; of those that have it minus the others
  double six_volumes = 0;         // enclosed, about a point near the piece
  double facing = 0;              // along a direction without symmetries
  bool closed = true;

  // Areas that differ by less are equal: the sum of many that should cancel.
  static constexpr double rounding = 1e-9;

  bool turn() const {
    if (std::abs(majority) > rounding * area) return majority < 0;
    return closed ? six_volumes < 0 : facing < 0;
  }
};

std::vector<Votes> count_votes(const SurfaceMesh& mesh, const std::vector<Side>& sides,
                               const OrientedPieces& pieces) {
  std::vector<Votes> votes(pieces.piece.size());
  for (int t = 0; t < mesh.triangles.rows(); ++t) {
    const int root = pieces.piece[at(t)];
    Votes& piece = votes[at(root)];
    const int* v = mesh.triangles.data() + 3 * t;
    const double sign = pieces.turned[at(t)] ? -1 : 1, area = triangle_shape(mesh.vertices, v).area();
    piece.area += area;
    piece.majority += sign * area;
    const Vector3 normal =
        cross(edge_vector(mesh.vertices, v[0], v[1]), edge_vector(mesh.vertices, v[0], v[2]));
    piece.six_volumes += sign * dot(normal, edge_vector(mesh.vertices, mesh.triangles(root, 0), v[0]));
    piece.facing += sign * dot(normal, {0.427, 0.811, 0.399});
  }
  for_each_edge(sides, [&](const Side* begin, const Side* end) {
    for (const Side* side = begin; side < end && end - begin != 2; ++side)
      votes[at(pieces.piece[at(side->triangle)])].closed = false;
  });
  return votes;
}

class Repair {
 public:
  explicit Repair(SurfaceMesh& mesh) : mesh_(mesh) {
    report_.original_triangle.resize(at(static_cast<int>(mesh.triangles.rows())));
    std::iota(report_.original_triangle.begin(), report_.original_triangle.end(), 0);
    report_.original_vertex.resize(at(static_cast<int>(mesh.vertices.rows())));
    std::iota(report_.original_vertex.begin(), report_.original_vertex.end(), 0);
    report_.new_vertex = report_.original_vertex;
  }

  void remove(const std::vector<int>& triangles, std::vector<int>& removed) {
    removed = in_input(triangles);
    if (triangles.empty()) return;
    std::vector<int> kept;
    for (int t = 0; t < mesh_.triangles.rows(); ++t)
      if (!std::binary_search(triangles.begin(), triangles.end(), t)) kept.push_back(t);
    report_.original_triangle = in_input(kept);
    mesh_.triangles = gather(mesh_.triangles, kept);
    if (mesh_.has_uv()) mesh_.uv_triangles = gather(mesh_.uv_triangles, kept);
  }

  void orient(bool turn) {
    const std::vector<Side> sides = sorted_sides(mesh_.triangles);
    const OrientedPieces pieces = oriented_pieces(mesh_.triangles, sides);
    const std::vector<Votes> votes = count_votes(mesh_, sides, pieces);
    for (int t = 0; t < mesh_.triangles.rows(); ++t) {
      const int root = pieces.piece[at(t)];
      if (pieces.one_sided[at(t)]) report_.one_sided.push_back(report_.original_triangle[at(t)]);
      if (!turn || pieces.one_sided[at(root)]) continue;
      if ((pieces.turned[at(t)] != 0) == votes[at(root)].turn()) continue;
      std::swap(mesh_.triangles(t, 1), mesh_.triangles(t, 2));
      if (mesh_.has_uv()) std::swap(mesh_.uv_triangles(t, 1), mesh_.uv_triangles(t, 2));
      report_.turned.push_back(report_.original_triangle[at(t)]);
    }
  }

  // The fan of the smallest corner keeps the vertex.
  void split_vertices() {
    UnionFind fans = corner_fans(mesh_.triangles, sorted_sides(mesh_.triangles));
    const auto corners = static_cast<int>(mesh_.triangles.size());
    std::vector<int> fan_of(report_.original_vertex.size(), -1), copy_of(at(corners), -1);
    for (int corner = 0; corner < corners; ++corner) {
      if (repeats_vertex(mesh_.triangles, corner / 3)) continue;  // in no fan
      int& vertex = mesh_.triangles.data()[corner];
      const int fan = fans.find(corner);
      if (fan_of[at(vertex)] < 0) fan_of[at(vertex)] = fan;
      if (fan_of[at(vertex)] == fan) continue;
      if (copy_of[at(fan)] < 0) {
        copy_of[at(fan)] = static_cast<int>(report_.original_vertex.size());
        report_.original_vertex.push_back(vertex);
        report_.split_vertices.push_back(vertex);
      }
      vertex = copy_of[at(fan)];
    }
    auto& split = report_.split_vertices;
    std::sort(split.begin(), split.end());
    split.erase(std::unique(split.begin(), split.end()), split.end());
    mesh_.vertices = gather(mesh_.vertices, report_.original_vertex);
  }

  void remove_unreferenced() {
    std::vector<int> number(report_.original_vertex.size(), -1), kept;
    for (Eigen::Index i = 0; i < mesh_.triangles.size(); ++i) number[at(mesh_.triangles.data()[i])] = 0;
    for (std::size_t v = 0; v < number.size(); ++v)
      if (number[v] < 0) {
        report_.unreferenced.push_back(report_.original_vertex[v]);
        report_.new_vertex[v] = -1;
      } else {
        number[v] = static_cast<int>(kept.size());
        kept.push_back(static_cast<int>(v));
        if (v < report_.new_vertex.size()) report_.new_vertex[v] = number[v];
      }
    for (Eigen::Index i = 0; i < mesh_.triangles.size(); ++i)
      mesh_.triangles.data()[i] = number[at(mesh_.triangles.data()[i])];
    mesh_.vertices = gather(mesh_.vertices, kept);
    for (int& v : kept) v = report_.original_vertex[at(v)];
    report_.original_vertex = std::move(kept);
  }

  void find_zero_areas() {
    for (int t = 0; t < mesh_.triangles.rows(); ++t)
      if (triangle_shape(mesh_.vertices, mesh_.triangles.data() + 3 * t).degenerate())
        report_.zero_area.push_back(report_.original_triangle[at(t)]);
  }

  RepairReport& report() { return report_; }

 private:
  std::vector<int> in_input(std::vector<int> triangles) const {
    for (int& t : triangles) t = report_.original_triangle[at(t)];
    return triangles;
  }

  SurfaceMesh& mesh_;
  RepairReport report_;
};

void append(std::string& text, const std::vector<int>& elements, const char* what, const char* done) {
  if (elements.empty()) return;
  constexpr std::size_t listed = 10;
  text += std::to_string(elements.size()) + " " + what + " " + done + ": ";
  for (std::size_t i = 0; i < std::min(listed, elements.size()); ++i)
    text += (i ? ", " : "") + std::to_string(elements[i]);
  text += elements.size() > listed ? ", ...\n" : "\n";
}

}  // namespace

RepairReport repair(SurfaceMesh& mesh, const RepairOptions& options) {
  require_indices(mesh.triangles, mesh.vertices.rows(), "triangle");
  Repair repair(mesh);
  RepairReport& report = repair.report();
  if (options.remove_degenerate) repair.remove(degenerate_triangles(mesh.triangles), report.degenerate);
  if (options.remove_duplicates) repair.remove(duplicate_triangles(mesh.triangles), report.duplicates);
  repair.orient(options.orient);
  if (options.split_vertices) repair.split_vertices();
  if (options.remove_unreferenced) repair.remove_unreferenced();
  repair.find_zero_areas();
  return std::move(report);
}

std::string to_text(const RepairReport& report) {
  std::string text;
  append(text, report.degenerate, "triangle(s) that repeat a vertex", "removed");
  append(text, report.duplicates, "duplicate triangle(s)", "removed");
  append(text, report.turned, "triangle(s)", "turned");
  append(text, report.split_vertices, "non-manifold vertex(es)", "split");
  append(text, report.unreferenced, "vertex(es) of no triangle", "removed");
  append(text, report.zero_area, "triangle(s) of zero area", "left as they are");
  append(text, report.one_sided, "piece(s) that cannot be oriented", "left as they are, with triangle");
  return text;
}

}  // namespace isostretch::mesh
