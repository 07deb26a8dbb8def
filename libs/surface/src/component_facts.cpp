#include "defects.hpp"
#include "orient.hpp"

#include <isostretch/core/index.hpp>
#include <isostretch/mesh/measure.hpp>
#include <isostretch/surface/components.hpp>

#include <string>
#include <utility>

namespace isostretch::mesh {
namespace {

class Counter {
 public:
  Counter(const SurfaceMesh& mesh, const std::vector<Side>& sides, std::vector<ComponentFacts>& facts)
      : mesh_(mesh),
        sides_(sides),
        facts_(facts),
        component_(component_of_triangles(mesh.triangles, static_cast<int>(mesh.vertices.rows()))) {}

  void count(const OrientedPieces& pieces) {
    count_triangles();
    count_edges();
    count_loops();
    count_fans();
    find_one_sided(pieces);
    find_folded();
    for (ComponentFacts& each : facts_)
      if (each.why_no_genus.empty()) each.genus = (2 - each.euler_characteristic - each.boundary_loops) / 2;
  }

 private:
  ComponentFacts& facts(int triangle) { return facts_[at(component_[at(triangle)])]; }
  // The first reason stays.
  void no_genus(int triangle, const std::string& why) {
    ComponentFacts& of = facts(triangle);
    if (of.why_no_genus.empty()) of.why_no_genus = why;
  }

  void count_triangles() {
    std::vector<char> seen(at(static_cast<int>(mesh_.vertices.rows())), 0);
    for (int t = 0; t < mesh_.triangles.rows(); ++t) {
      if (at(component_[at(t)]) == facts_.size()) facts_.emplace_back().first_triangle = t;
      ComponentFacts& of = facts(t);
      ++of.triangles;
      ++of.euler_characteristic;
      of.area += triangle_shape(mesh_.vertices, mesh_.triangles.data() + 3 * t).area();
      for (int c = 0; c < 3; ++c)
        if (!std::exchange(seen[at(mesh_.triangles(t, c))], 1)) {
          ++of.vertices;
          ++of.euler_characteristic;
        }
    }
  }

  void count_edges() {
    std::vector<char> has_sides(component_.size(), 0);
    for_each_edge(sides_, [&](const Side* begin, const Side* end) {
      --facts(begin->triangle).euler_characteristic;
      if (end - begin > 2)
        no_genus(begin->triangle, "edge " + std::to_string(begin->low) + "-" + std::to_string(begin->high) +
                                      " belongs to " + std::to_string(end - begin) + " triangles");
    });
    for (const Side& side : sides_) has_sides[at(side.triangle)] = 1;
    for (int t = 0; t < mesh_.triangles.rows(); ++t)
      if (!has_sides[at(t)]) no_genus(t, "triangle " + std::to_string(t) + " repeats a vertex");
  }

  // Connected components of the boundary edges.
  void count_loops() {
    UnionFind sets(static_cast<int>(mesh_.vertices.rows()));
    std::vector<const Side*> boundary;
    for_each_edge(sides_, [&](const Side* begin, const Side* end) {
      if (end - begin != 1) return;
      sets.unite(begin->low, begin->high);
      boundary.push_back(begin);
    });
    std::vector<char> counted(at(static_cast<int>(mesh_.vertices.rows())), 0);
    for (const Side* side : boundary)
      if (!std::exchange(counted[at(sets.find(side->low))], 1)) ++facts(side->triangle).boundary_loops;
  }

  void count_fans() {
    UnionFind fans = corner_fans(mesh_.triangles, sides_);
    std::vector<int> fan_of(at(static_cast<int>(mesh_.vertices.rows())), -1);
    for (const Side& side : sides_) {
      const int fan = fans.find(3 * side.triangle + side.corner);
      int& known = fan_of[at(side.from())];
      if (known < 0) known = fan;
      if (known != fan)
        no_genus(side.triangle,
                 "vertex " + std::to_string(side.from()) + " joins pieces that share no edge there");
    }
  }

  void find_one_sided(const OrientedPieces& pieces) {
    for (int t = 0; t < mesh_.triangles.rows(); ++t)
      if (pieces.one_sided[at(pieces.piece[at(t)])])
        no_genus(t, "it is not orientable");
      else if (pieces.turned[at(t)])
        no_genus(t, "triangles " + std::to_string(pieces.piece[at(t)]) + " and " + std::to_string(t) +
                        " are oriented against each other");
  }

  // Duplicates that share no edge with a third triangle.
  void find_folded() {
    for (const ComponentFacts& each : facts_)
      if (each.triangles == 2 && each.boundary_loops == 0)
        no_genus(each.first_triangle, "its two triangles have the same vertices");
  }

  const SurfaceMesh& mesh_;
  const std::vector<Side>& sides_;
  std::vector<ComponentFacts>& facts_;
  std::vector<int> component_;
};

}  // namespace

void count_topology(const SurfaceMesh& mesh, const std::vector<Side>& sides, const OrientedPieces& pieces,
                    MeshDiagnostics& diagnostics) {
  Counter(mesh, sides, diagnostics.component_facts).count(pieces);
  diagnostics.genus = 0;
  for (const ComponentFacts& facts : diagnostics.component_facts) {
    diagnostics.euler_characteristic += facts.euler_characteristic;
    diagnostics.boundary_loops += facts.boundary_loops;
    if (facts.genus < 0) diagnostics.genus = -1;
    if (diagnostics.genus >= 0) diagnostics.genus += facts.genus;
  }
}

}  // namespace isostretch::mesh
