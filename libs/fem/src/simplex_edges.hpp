#pragma once

namespace isostretch::mesh {

// Corners at the ends of each edge, in VTK's order of nodes on edges: of triangles the first three, of tets
// all.
inline constexpr int simplex_edges[6][2] = {{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 3}, {2, 3}};

template <int Dim>
inline constexpr int simplex_edge_count = Dim == 2 ? 3 : 6;

}  // namespace isostretch::mesh
