#pragma once

#include <isostretch/surface/topology.hpp>

#include <vector>

namespace isostretch::mesh {

// Triangles connected through edges of exactly two, and how each would have to be turned for all of a piece
// to be oriented alike.
struct OrientedPieces {
  std::vector<int> piece;       // of every triangle: the smallest triangle of its piece
  std::vector<char> turned;     // against that smallest triangle; meaningless where one-sided
  std::vector<char> one_sided;  // of every smallest triangle: no orientation fits the piece
};

OrientedPieces oriented_pieces(const Triangles& triangles, const std::vector<Side>& sides);

}  // namespace isostretch::mesh
