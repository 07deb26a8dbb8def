#pragma once

#include <isostretch/cholesky/analysis.hpp>

#include <cstdint>
#include <vector>

namespace isostretch::cholesky {

// What is done at a time: a whole subtree, by one thread, or a supernode of the top of the tree.
struct Unit {
  int begin = 0, root = 0;  // supernodes begin ... root; one of the top is both
  bool is_top = false;
  int parent = -1;       // number of the unit that waits for this one; -1: none
  int children = 0;      // units that it waits for
  double flops = 0;      // of the subtree below, itself included
  double path = 0;       // operations of the unit and those above it up to the root
  bool changes = false;  // has supernodes that are eliminated last: what a refactorization does again
};

// The units. They do not depend on the number of threads.
struct Schedule {
  std::vector<Unit> unit;         // ascending
  std::vector<int> subtree, top;  // numbers of units: the largest subtrees first, the top ascending
  double flops = 0;               // of all
  double most_of_subtree = 0;     // operations of a subtree that is one unit, at most
  std::int64_t stack = 0;         // values of the largest stack of a subtree
  int most_rows = 0;              // of a front

  Schedule() = default;
  explicit Schedule(const Structure& structure);
};

// Values of the update matrix.
std::int64_t update_values(const Supernode& supernode);

}  // namespace isostretch::cholesky
