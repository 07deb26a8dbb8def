#pragma once

#include "cut_graph.hpp"

namespace isostretch::mesh {

// Throws Error saying why the surface cannot be cut to disks.
void require_cuttable(const SurfaceMesh& mesh);

// A connected mesh, every vertex in a triangle, as what is to be cut.
Piece make_piece(const SurfaceMesh& mesh);

}  // namespace isostretch::mesh
