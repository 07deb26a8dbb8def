#pragma once

#include <isostretch/mesh/types.hpp>

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace isostretch::mesh {

/// The defects that check() looks for in a mesh.
enum class DefectKind {
  /// An index is out of range.
  index_out_of_range,
  not_finite,           ///< A coordinate is NaN or infinite.
  degenerate,           ///< An element repeats a vertex.
  zero_size,            ///< An area (volume) is zero to rounding: height below 1e-15 of the longest edge.
  inverted,             ///< A tetrahedron has negative volume.
  duplicate_element,    ///< An element has the vertices of an earlier one.
  non_manifold_edge,    ///< An edge has more than two triangles.
  non_manifold_face,    ///< A face has more than two tetrahedra.
  non_manifold_vertex,  ///< The triangles of a vertex form more than one fan.
  not_orientable,  ///< A piece is one-sided, like a Moebius strip: its triangles cannot be oriented alike.
  /// Two triangles run through their edge in the same direction, and one of them could be turned; or two
  /// tetrahedra see their face from the same side.
  inconsistent_orientation,
  /// A vertex is in no element.
  unreferenced_vertex,
  duplicate_vertex,  ///< A vertex is exactly where an earlier one is; for information, as on every seam.
  /// The mesh has several components.
  several_components
};
/// The number of kinds of defects.
inline constexpr int defect_kind_count = 14;

/// Returns the name of the enumerator, such as "zero_size".
std::string_view defect_kind_name(DefectKind kind) noexcept;

/// A defect of a mesh, with the elements and vertices concerned.
struct Defect {
  DefectKind kind;            ///< The kind of defect.
  std::vector<int> elements;  ///< Triangles or tetrahedra concerned.
  std::vector<int> vertices;  ///< Vertices concerned.
  std::string text;           ///< A sentence that names them, without the final stop.
};

/// The topology of a component: triangles that are connected through shared vertices.
struct ComponentFacts {
  int first_triangle = 0;        ///< The smallest of its triangles.
  int triangles = 0;             ///< Number of triangles.
  int vertices = 0;              ///< Number of vertices.
  int boundary_loops = 0;        ///< Number of boundary loops.
  int euler_characteristic = 0;  ///< vertices - edges + triangles.
  double area = 0;               ///< Sum of areas.
  int genus = -1;                ///< Number of handles, -1 where it is not defined.
  std::string why_no_genus;      ///< The reason where the genus is not defined, else empty.
};

/// The defects and the topology of a mesh.
struct MeshDiagnostics {
  std::vector<Defect> defects;  ///< At most max_per_kind of each kind, in the order of the enumeration.
  std::array<long, defect_kind_count> counts = {};  ///< Number of defects of each kind, listed or not.
  /// Whether all indices are in range; if not, only indices were looked at, and the numbers below are 0.
  bool indices_valid = true;

  int components = 0;  ///< Components connected through shared vertices; unreferenced vertices do not count.
  /// Boundary loops of a triangle mesh.
  int boundary_loops = 0;
  int euler_characteristic = 0;  ///< Referenced vertices - edges + triangles, of a triangle mesh.
  /// Sum over the components of a triangle mesh, -1 where it is not defined (not manifold or not oriented).
  int genus = -1;
  /// Components of a triangle mesh, in the order of component_of_triangles.
  std::vector<ComponentFacts> component_facts;

  /// Returns whether nothing was found but duplicate vertices, which are no fault.
  bool clean() const;
  /// Returns the number of defects of a kind, listed or not.
  long count(DefectKind kind) const { return counts[static_cast<std::size_t>(kind)]; }
  /// Returns the first defect of a kind that is listed, or null.
  const Defect* find(DefectKind kind) const;
};

/// Returns the numbers, a line for each component, and the defects by kind with the elements that they name;
/// ends with a newline. Of many components the first are listed.
std::string to_text(const MeshDiagnostics& diagnostics);

/// Returns the defects and the topology of a triangle mesh, with at most max_per_kind defects listed of each
/// kind. Throws nothing, whatever the mesh.
MeshDiagnostics check(const SurfaceMesh& mesh, int max_per_kind = 20);
/// Returns the defects of a tetrahedral mesh, with at most max_per_kind listed of each kind. Kinds that name
/// triangles or edges do not occur. Throws nothing, whatever the mesh.
MeshDiagnostics check(const TetMesh& mesh, int max_per_kind = 20);

/// Throws Error unless the mesh is a topological disk, saying why it is not and naming the element at fault:
/// no boundary, several boundary loops, genus, several components, or any defect except zero_size and
/// duplicate_vertex, which are matters of geometry.
void require_disk(const SurfaceMesh& mesh);
/// Throws Error unless the mesh that was checked is a topological disk, saying why it is not and naming the
/// element at fault.
void require_disk(const MeshDiagnostics& diagnostics);

}  // namespace isostretch::mesh
