#include "cuthill_mckee.hpp"

#include <algorithm>

namespace isostretch::sparse {
namespace {

class Ordering {
 public:
  Ordering(const std::vector<int>& start, const std::vector<int>& neighbour)
      : start_(start), neighbour_(neighbour), seen_(start.size() - 1, 0) {}

  std::vector<int> compute() {
    const int nodes = static_cast<int>(seen_.size());
    for (int node = 0; node < nodes; ++node)
      if (seen_[node] == 0) walk(far_from(node));
    std::reverse(order_.begin(), order_.end());
    return std::move(order_);
  }

 private:
  // The last node that a walk from `node` reaches; the walk is undone.
  int far_from(int node) {
    const std::size_t begin = order_.size();
    walk(node);
    const int last = order_.back();
    for (std::size_t k = begin; k < order_.size(); ++k) seen_[order_[k]] = 0;
    order_.resize(begin);
    return last;
  }

  // Breadth first; neighbours of low degree first.
  void walk(int root) {
    const auto degree = [&](int node) { return start_[node + 1] - start_[node]; };
    std::size_t next = order_.size();
    order_.push_back(root);
    seen_[root] = 1;
    while (next < order_.size()) {
      const int node = order_[next++];
      const std::size_t begin = order_.size();
      for (int k = start_[node]; k < start_[node + 1]; ++k) {
        char& seen = seen_[neighbour_[k]];
        if (seen != 0) continue;
        seen = 1;
        order_.push_back(neighbour_[k]);
      }
      std::sort(order_.begin() + static_cast<std::ptrdiff_t>(begin), order_.end(),
                [&](int a, int b) { return degree(a) != degree(b) ? degree(a) < degree(b) : a < b; });
    }
  }

  const std::vector<int>&start_, &neighbour_;
  std::vector<char> seen_;
  std::vector<int> order_;
};

}  // namespace

std::vector<int> reverse_cuthill_mckee(const std::vector<int>& start, const std::vector<int>& neighbour) {
  return Ordering(start, neighbour).compute();
}

}  // namespace isostretch::sparse
