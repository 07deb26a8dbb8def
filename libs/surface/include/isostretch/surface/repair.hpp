#pragma once

#include <isostretch/mesh/element_mesh.hpp>
#include <isostretch/mesh/types.hpp>

#include <string>
#include <vector>

namespace isostretch::mesh {

/// The repairs of a triangle mesh that have one right answer, carried out in this order.
struct RepairOptions {
  bool remove_degenerate = true;  ///< Removes triangles that repeat a vertex.
  bool remove_duplicates = true;  ///< Removes triangles with the vertices of an earlier one.
  /// Orients the triangles of a piece (connected through edges of two triangles) alike, as the larger part of
  /// its area is. If both are equal, a closed piece is oriented outward, an open one by the direction it
  /// faces.
  bool orient = true;
  bool split_vertices = false;  ///< Gives each piece without a common edge at a vertex a copy of the vertex.
  bool remove_unreferenced = true;  ///< Removes vertices of no triangle.
};

/// The changes of a repair, in the numbering of the input, and the maps between both.
struct RepairReport {
  std::vector<int> degenerate;      ///< Triangles removed because they repeat a vertex.
  std::vector<int> duplicates;      ///< Triangles removed because they have the vertices of an earlier one.
  std::vector<int> turned;          ///< Triangles oriented the other way.
  std::vector<int> split_vertices;  ///< Vertices that were split; their copies come last.
  std::vector<int> unreferenced;    ///< Vertices removed.
  /// Triangles of zero area, which stay.
  std::vector<int> zero_area;  ///< triangles
  std::vector<int> one_sided;  ///< A triangle of every piece that is not orientable; it was left as it was.
  std::vector<int> original_vertex;    ///< Vertex of the input of every vertex.
  std::vector<int> original_triangle;  ///< Triangle of the input of every triangle.
  std::vector<int> new_vertex;         ///< Vertex of every vertex of the input, or -1.

  /// Returns whether anything was changed.
  bool changed() const {
    return !(degenerate.empty() && duplicates.empty() && turned.empty() && split_vertices.empty() &&
             unreferenced.empty());
  }
};

/// Repairs a triangle mesh and returns the changes; uv is carried along. Which triangles are turned depends
/// on geometry, not on their order. Throws Error when an index is out of range. check() finds what is left.
RepairReport repair(SurfaceMesh& mesh, const RepairOptions& options = {});

/// The changes of a repair of elements, or those that would be needed, in the numbering of the input.
struct ElementRepairReport {
  std::vector<int> duplicates;  ///< Elements with the vertices of an earlier one, in any order.
  std::vector<int> inverted;    ///< Elements of negative volume, or of negative area in the plane z = 0.

  /// Returns whether there is nothing to repair.
  bool clean() const { return duplicates.empty() && inverted.empty(); }
};

/// Returns the elements that are there twice, and those that are numbered the other way round. Flat elements
/// are taken as lying in the plane z = 0. Throws Error when an index is out of range.
ElementRepairReport find_faults(const ElementMesh& mesh);

/// Removes the duplicates and turns the inverted elements, in the groups too, and returns what find_faults()
/// had found. Throws Error when an index is out of range.
ElementRepairReport repair(ElementMesh& mesh);

/// Returns a line for each kind of change, naming elements; ends with a newline unless empty.
std::string to_text(const RepairReport& report);

}  // namespace isostretch::mesh
