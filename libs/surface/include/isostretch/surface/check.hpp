#pragma once

#include <isostretch/mesh/types.hpp>

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace isostretch::mesh {

enum class Kind {
  index_out_of_range,
  not_finite,                ///< a coordinate is NaN or infinite
  degenerate,                ///< an element repeats a vertex
  zero_size,                 ///< area (volume) zero to rounding: height below 1e-15 of the longest edge
  inverted,                  ///< a tetrahedron with negative volume
  duplicate_element,         ///< same vertices as an earlier element
  non_manifold_edge,         ///< more than two triangles
  non_manifold_face,         ///< more than two tets
  non_manifold_vertex,       ///< its triangles form more than one fan
  not_orientable,            ///< one-sided, like a Moebius strip: triangles cannot be oriented alike
  inconsistent_orientation,  ///< two triangles run through their edge in the same direction, and could be
                             ///< turned; two tets see their face from the same side
  unreferenced_vertex,
  duplicate_vertex,  ///< exactly where an earlier one is; for information, as on every seam
  several_components
};
inline constexpr int kind_count = 14;

std::string_view kind_name(Kind kind) noexcept;

struct Finding {
  Kind kind;
  std::vector<int> elements;  ///< triangles or tets concerned
  std::vector<int> vertices;
  std::string text;  ///< a sentence naming them, without the final stop
};

/// Of triangles connected through shared vertices.
struct ComponentFacts {
  int first_triangle = 0;  ///< the smallest
  int triangles = 0;
  int vertices = 0;
  int boundary_loops = 0;
  int euler_characteristic = 0;  ///< vertices - edges + triangles
  double area = 0;
  int genus = -1;            ///< -1: not defined
  std::string why_no_genus;  ///< empty when it is defined
};

struct Report {
  std::vector<Finding> findings;             ///< at most max_per_kind of each kind, in order of Kind
  std::array<long, kind_count> counts = {};  ///< of all, listed or not
  bool indices_valid = true;                 ///< false: only indices were looked at, the numbers below are 0

  int components = 0;  ///< connected through shared vertices; unreferenced vertices do not count
  /// Triangle meshes only:
  int boundary_loops = 0;
  int euler_characteristic = 0;  ///< referenced vertices - edges + triangles
  int genus = -1;                ///< summed over components; -1: not defined (not manifold or not oriented)
  std::vector<ComponentFacts> component_facts;  ///< in the order of component_of_triangles

  /// Nothing found but duplicate vertices, which are no fault.
  bool clean() const;
  long count(Kind kind) const { return counts[static_cast<std::size_t>(kind)]; }
  /// First finding of that kind, or null.
  const Finding* find(Kind kind) const;
};

/// The numbers, a line for each component, and findings by kind with the elements they name; ends with a
/// newline. Of many components the first are listed.
std::string to_text(const Report& report);

/// Looks at everything, throws nothing.
Report check(const SurfaceMesh& mesh, int max_per_kind = 20);
/// Kinds that name triangles or edges do not occur.
Report check(const TetMesh& mesh, int max_per_kind = 20);

/// Throws Error saying why the mesh is not a topological disk, naming the element at fault: no boundary,
/// several boundary loops, genus, several components, or any finding except zero_size and
/// duplicate_vertex (which are matters of geometry).
void require_disk(const SurfaceMesh& mesh);
/// The same from a report at hand.
void require_disk(const Report& report);

}  // namespace isostretch::mesh
