#pragma once

#include "element_labels.hpp"
#include "face_list.hpp"
#include "place.hpp"

#include <isostretch/mesh/element_mesh.hpp>
#include <isostretch/mesh/types.hpp>
#include <isostretch/mesh_io/io.hpp>

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace isostretch::mesh {

enum class Family { point, line, triangle, quad, polygon, tet, hex, prism, pyramid, polyhedron };

// An element of a file: its family, and its nodes where these tell the order.
struct CellKind {
  Family family = Family::point;
  int nodes = 0;

  int dimension() const;
  auto operator<=>(const CellKind&) const = default;
};

// "2 tetrahedra", "1 hexahedron of 20 nodes".
std::string counted(CellKind kind, long count);

// What is made of a file: its faces, its linear tetrahedra, or the elements of the highest dimension in it.
enum class Wanted { surface, tets, elements };

// Elements of a file that may hold several kinds. Those asked for are kept, the rest is only counted.
class ElementList {
 public:
  ElementList(Wanted wanted, const ReadOptions& options) : wanted_(wanted), faces_(options) {}

  bool wants(CellKind kind) const;
  // A wanted one, its nodes from 0 in VTK's order.
  void add(CellKind kind, const std::vector<int>& nodes, const Place& place, const ElementLabel& label = {});
  void skip(CellKind kind, long count = 1);
  std::string face_fault(std::size_t corners) const { return faces_.fault(corners); }
  void name_group(int dimension, std::int64_t number, std::string_view name);
  // An element in several groups may be there several times, once for each of them, as in MSH 2.
  void merge_copies_of_groups() { copies_for_groups_ = true; }

  // What the whole file makes, of vertices x, y, z and texture coordinates u, v each. They throw Error at the
  // end of the file when it holds nothing of the kind wanted, or something beside it that must not be
  // dropped.
  SurfaceMesh surface(const std::vector<double>& vertices, const std::vector<double>& uv, const Place& end);
  TetMesh tets(const std::vector<double>& vertices, const Place& end);
  ElementMesh elements(const std::vector<double>& vertices, const Place& end);

  // Of one shape, all of the same number of nodes; flat.
  std::vector<int>& nodes_of(Shape shape) { return lists_[static_cast<std::size_t>(shape)].nodes; }

 private:
  struct List {
    std::vector<int> nodes;
    ElementLabels labels;
  };

  long count(int dimension) const;
  std::string listed(int dimension) const;
  std::string missing_faces() const;
  void require_one_kind(int dimension, const Place& end) const;
  void drop_copies(List& list, int nodes_each, const Place& end) const;
  std::string group_name(int dimension, std::int64_t number) const;
  std::vector<ElementGroup> groups_of(const List& list, int dimension) const;
  void add_lower_groups(int dimension, std::vector<ElementGroup>& groups) const;

  Wanted wanted_;
  bool copies_for_groups_ = false;
  FaceList faces_;
  ElementLabels face_labels_;
  std::array<List, 6> lists_;  // by Shape
  std::map<CellKind, long> counts_;
  CellKind last_kind_;
  long* last_count_ = nullptr;  // into counts_, where moving leaves it
  std::map<std::pair<int, std::int64_t>, std::string> group_names_;
  std::map<std::pair<int, std::int64_t>, std::vector<int>> lines_and_points_;  // vertices of their groups
};

// What a reader hands over.
struct MixedMesh {
  std::vector<double> vertices;
  ElementList elements;
  Place end;
  std::vector<double> uv = {};  // u and v of every vertex, or none
};

inline SurfaceMesh surface_of(MixedMesh mesh) {
  return mesh.elements.surface(mesh.vertices, mesh.uv, mesh.end);
}
inline TetMesh tets_of(MixedMesh mesh) {
  return mesh.elements.tets(mesh.vertices, mesh.end);
}
inline ElementMesh elements_of(MixedMesh mesh) {
  return mesh.elements.elements(mesh.vertices, mesh.end);
}

}  // namespace isostretch::mesh
