#pragma once

#include <isostretch/cholesky/analysis.hpp>

#include <cstdint>
#include <vector>

namespace isostretch::cholesky {

// What threads do by themselves and together: whole subtrees, and the supernodes above them in the order of
// elimination. It does not depend on the number of threads, and so neither does what is found first.
struct Schedule {
  struct Subtree {
    int begin = 0, root = 0;  // supernodes begin ... root
  };
  std::vector<Subtree> subtree;      // the largest first
  std::vector<int> top;              // ascending
  std::vector<std::int64_t> update;  // of roots and top: where their update matrices are in the pool
  std::int64_t stack = 0;            // values of the largest stack of a subtree
  std::int64_t pool = 0;             // values of the pool
  int most_rows = 0;                 // of a front

  Schedule() = default;
  explicit Schedule(const Structure& structure);
};

// The distance of the columns of an update matrix, and all its values.
std::int64_t update_leading(const Supernode& supernode);
std::int64_t update_values(const Supernode& supernode);

}  // namespace isostretch::cholesky
