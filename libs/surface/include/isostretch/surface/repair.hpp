#pragma once

#include <isostretch/mesh/element_mesh.hpp>
#include <isostretch/mesh/types.hpp>

#include <string>
#include <vector>

namespace isostretch::mesh {

/// What has one right answer. Carried out in this order.
struct RepairOptions {
  bool remove_degenerate = true;  ///< triangles that repeat a vertex
  bool remove_duplicates = true;  ///< triangles with the vertices of an earlier one
  /// Triangles of a piece (connected through edges of two triangles) all oriented alike, as the larger part
  /// of its area is. If both are equal: a closed piece outward, an open one by the direction it faces.
  bool orient = true;
  bool split_vertices = false;  ///< a vertex that joins pieces without a common edge: a copy for each piece
  bool remove_unreferenced = true;  ///< vertices of no triangle
};

/// What was changed, in the numbering of the input, and the maps between both.
struct RepairReport {
  std::vector<int> degenerate;      ///< triangles removed
  std::vector<int> duplicates;      ///< triangles removed
  std::vector<int> turned;          ///< triangles oriented the other way
  std::vector<int> split_vertices;  ///< their copies come last
  std::vector<int> unreferenced;    ///< vertices removed
  /// Not repaired:
  std::vector<int> zero_area;  ///< triangles
  std::vector<int> one_sided;  ///< a triangle of every piece that is not orientable; it was left as it was
  std::vector<int> original_vertex;    ///< vertex -> vertex of the input
  std::vector<int> original_triangle;  ///< triangle -> triangle of the input
  std::vector<int> new_vertex;         ///< vertex of the input -> vertex, or -1

  bool changed() const {
    return !(degenerate.empty() && duplicates.empty() && turned.empty() && split_vertices.empty() &&
             unreferenced.empty());
  }
};

/// uv is carried along. Which triangles are turned depends on geometry, not on their order. Throws Error when
/// an index is out of range. See check.hpp for what is left to find.
RepairReport repair(SurfaceMesh& mesh, const RepairOptions& options = {});

/// What was changed in elements, or would have to be, in the numbering of the input.
struct ElementRepairReport {
  std::vector<int> duplicates;  ///< elements with the vertices of an earlier one, in any order
  std::vector<int> inverted;    ///< elements of negative volume, or of negative area in the plane z = 0

  /// Whether there is nothing to repair.
  bool clean() const { return duplicates.empty() && inverted.empty(); }
};

/// Finds elements that are there twice, and those that are numbered the other way round. Flat elements are
/// taken as lying in the plane z = 0. Throws Error when an index is out of range.
ElementRepairReport find_faults(const ElementMesh& mesh);

/// Removes the duplicates and turns the inverted elements, in the groups too, and says what find_faults() had
/// found. Throws Error when an index is out of range.
ElementRepairReport repair(ElementMesh& mesh);

/// A line for each kind of change, naming elements; ends with a newline unless empty.
std::string to_text(const RepairReport& report);

}  // namespace isostretch::mesh
