#pragma once

#include <isostretch/cholesky/analysis.hpp>

#include <vector>

namespace isostretch::cholesky {

// The entries of the lower triangle in the order of elimination: of position j the positions of its rows, j
// included, with the numbers of the entries.
struct LaterNeighbours {
  std::vector<int> start, position, entry;
};
LaterNeighbours later_neighbours(const Pattern& pattern, const std::vector<int>& position_of);

// Parents in the elimination tree (Liu 1986); -1 for roots.
std::vector<int> elimination_tree(const LaterNeighbours& later);

// Nodes of a forest so that children come before their parents and subtrees stay together.
std::vector<int> postorder(const std::vector<int>& parent);

// Entries of every column of L, for a tree that is numbered in a postorder (Gilbert, Ng, Peyton 1994).
// Position p of it is position post[p] of the neighbours: who is later stays so, for all of them are
// ancestors.
std::vector<int> column_counts(const LaterNeighbours& later, const std::vector<int>& post,
                               const std::vector<int>& parent);

// Positions of unknowns, or of positions of another order.
std::vector<int> inverse(const std::vector<int>& order);

}  // namespace isostretch::cholesky
