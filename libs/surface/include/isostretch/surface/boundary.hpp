#pragma once

#include <isostretch/mesh/types.hpp>

#include <vector>

namespace isostretch::mesh {

/// Returns the vertices of every boundary loop of a mesh, in the direction of the triangles' edges: the
/// surface is on the left. A loop starts at its smallest vertex; loops are ordered by it. A closed surface
/// has none. Throws Error naming a vertex or edge where the boundary branches (not manifold or not
/// consistently oriented), or an index out of range.
std::vector<std::vector<int>> boundary_loops(const SurfaceMesh& mesh);
/// Returns the vertices of every boundary loop of triangles over vertices 0 ... vertex_count - 1, in the
/// direction of the triangles' edges. A loop starts at its smallest vertex; loops are ordered by it. Throws
/// Error naming a vertex or edge where the boundary branches, or an index out of range.
std::vector<std::vector<int>> boundary_loops(const Triangles& triangles, int vertex_count);

/// Returns the sum of the lengths of a loop's edges, the one back to its first vertex included.
double loop_length(const SurfaceMesh& mesh, const std::vector<int>& loop);

/// Returns for every vertex the length of the shortest path along edges to the boundary of its component,
/// infinity where there is none. The mesh must be manifold and consistently oriented.
std::vector<double> distance_to_boundary(const SurfaceMesh& mesh);

/// Returns the index of the longest loop; there must be one.
std::size_t longest_loop(const SurfaceMesh& mesh, const std::vector<std::vector<int>>& loops);

}  // namespace isostretch::mesh
