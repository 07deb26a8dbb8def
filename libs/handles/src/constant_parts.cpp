#include "constant_parts.hpp"

#include <isostretch/core/index.hpp>

namespace isostretch::handles {
namespace {

struct Part {
  std::vector<int> nodes;
  std::vector<int> around;  // given nodes beside them, with repetitions
};

// The free nodes connected with one of them, which are taken out of `left`.
Part part_of(int first, const Rows& A, const std::vector<bool>& free, std::vector<bool>& left) {
  Part part{{first}, {}};
  left[at(first)] = false;
  for (std::size_t next = 0; next < part.nodes.size(); ++next)
    for (const Entry& entry : A[at(part.nodes[next])]) {
      if (!free[at(entry.column)])
        part.around.push_back(entry.column);
      else if (left[at(entry.column)])
        part.nodes.push_back(entry.column);
      left[at(entry.column)] = false;
    }
  return part;
}

bool one_value_around(const Part& part, const std::vector<double>& w, std::size_t nodes, int columns) {
  if (part.around.empty()) return false;
  for (std::size_t c = 0; c < at(columns); ++c)
    for (const int n : part.around)
      if (w[c * nodes + at(n)] != w[c * nodes + at(part.around[0])]) return false;
  return true;
}

}  // namespace

std::vector<bool> solve_constant_parts(const Rows& A, const std::vector<bool>& free, std::vector<double>& w,
                                       int columns) {
  const std::size_t nodes = free.size();
  std::vector<bool> left = free, to_solve = free;
  for (std::size_t first = 0; first < nodes; ++first) {
    if (!left[first]) continue;
    const Part part = part_of(static_cast<int>(first), A, free, left);
    if (!one_value_around(part, w, nodes, columns)) continue;
    for (const int n : part.nodes) {
      to_solve[at(n)] = false;
      for (std::size_t c = 0; c < at(columns); ++c) w[c * nodes + at(n)] = w[c * nodes + at(part.around[0])];
    }
  }
  return to_solve;
}

}  // namespace isostretch::handles
