#pragma once

#include <isostretch/cholesky/analysis.hpp>

#include <cstdint>
#include <vector>

namespace isostretch::cholesky {

// Supernodes before they are numbered: the columns of each are a list, in the order of elimination.
struct SupernodeTree {
  struct Node {
    int columns = 0;  // number of columns
    int rows = 0;     // of the front
    int parent = -1;
    int first = -1, last = -1;  // of the list of columns
    double zeros = 0;           // stored besides the entries of L
    bool is_last = false;       // one of those whose columns are eliminated last
    bool merged = false;        // into its parent: no node any more
  };
  std::vector<Node> node;  // children before parents
  std::vector<int> next;   // of every column, the next one of its node; -1: the last
};

// Supernodes of columns of one structure, from the tree, its counts and which columns are eliminated last,
// all numbered in postorder. None has columns of both kinds.
SupernodeTree fundamental_supernodes(const std::vector<int>& parent, const std::vector<int>& count,
                                     const std::vector<bool>& is_last);

// Merges children with their parents where the options say that this pays (relaxed amalgamation, Ashcraft and
// Grimes 1989). The child that adds the fewest zeros comes first.
void merge_supernodes(SupernodeTree& tree, const Amalgamation& options);

// The nodes that are left in an order in which the stack of update matrices stays small (Liu 1986): children
// first, those that need more than they leave before others.
std::vector<int> order_of_small_stack(const SupernodeTree& tree);

}  // namespace isostretch::cholesky
