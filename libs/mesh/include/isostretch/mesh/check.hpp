#pragma once

#include <isostretch/mesh/types.hpp>

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace isostretch::mesh {

enum class Kind {
  index_out_of_range,
  not_finite,                // a coordinate is NaN or infinite
  degenerate,                // an element repeats a vertex
  zero_size,                 // area (volume) zero to rounding: height below 1e-15 of the longest edge
  inverted,                  // a tetrahedron with negative volume
  duplicate_element,         // same vertices as an earlier element
  non_manifold_edge,         // more than two triangles
  non_manifold_vertex,       // its triangles form more than one fan
  inconsistent_orientation,  // two triangles run through their edge in the same direction
  unreferenced_vertex,
  several_components
};
inline constexpr int kind_count = 11;

std::string_view kind_name(Kind kind) noexcept;

struct Finding {
  Kind kind;
  std::vector<int> elements;  // triangles or tets concerned
  std::vector<int> vertices;
  std::string text;  // a sentence naming them, without the final stop
};

struct Report {
  std::vector<Finding> findings;             // at most max_per_kind of each kind, in order of Kind
  std::array<long, kind_count> counts = {};  // of all, listed or not
  bool indices_valid = true;                 // false: only indices were looked at, the numbers below are 0

  int components = 0;  // connected through shared vertices; unreferenced vertices do not count
  // Triangle meshes only:
  int boundary_loops = 0;
  int euler_characteristic = 0;  // referenced vertices - edges + triangles
  int genus = -1;                // summed over components; -1: not defined (not manifold or not oriented)

  bool clean() const { return findings.empty(); }
  long count(Kind kind) const { return counts[static_cast<std::size_t>(kind)]; }
  // First finding of that kind, or null.
  const Finding* find(Kind kind) const;
};

// Looks at everything, throws nothing.
Report check(const SurfaceMesh& mesh, int max_per_kind = 20);
// index_out_of_range, not_finite, degenerate, zero_size, inverted, duplicate_element, unreferenced_vertex,
// several_components.
Report check(const TetMesh& mesh, int max_per_kind = 20);

// Throws Error saying why the mesh is not a topological disk, naming the element at fault: no boundary,
// several boundary loops, genus, several components, or any finding except zero_size (which is a matter of
// geometry).
void require_disk(const SurfaceMesh& mesh);
// The same from a report at hand.
void require_disk(const Report& report);

}  // namespace isostretch::mesh
