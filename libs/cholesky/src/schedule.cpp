#include "schedule.hpp"

#include "padding.hpp"

#include <algorithm>
#include <iterator>
#include <map>

namespace isostretch::cholesky {
namespace {

// Pieces of a pool, the first that is large enough for each.
class Pool {
 public:
  std::int64_t take(std::int64_t values) {
    for (auto& [place, size] : free_) {
      if (size < values) continue;
      const std::int64_t taken = place, left = size - values;
      free_.erase(taken);
      if (left > 0) free_[taken + values] = left;
      return taken;
    }
    end_ += values;
    return end_ - values;
  }

  void give_back(std::int64_t place, std::int64_t values) {
    if (values == 0) return;
    auto next = free_.lower_bound(place);
    if (next != free_.end() && place + values == next->first) {
      values += next->second;
      next = free_.erase(next);
    }
    if (next != free_.begin()) {
      const auto before = std::prev(next);
      if (before->first + before->second == place) {
        before->second += values;
        return;
      }
    }
    free_[place] = values;
  }

  std::int64_t size() const { return end_; }

 private:
  std::map<std::int64_t, std::int64_t> free_;  // place and size
  std::int64_t end_ = 0;
};

std::vector<int> first_descendants(const Structure& structure) {
  std::vector<int> first(static_cast<std::size_t>(structure.count()));
  for (int s = 0; s < structure.count(); ++s) {
    const Supernode& node = structure.supernode[s];
    const bool is_leaf = node.child == structure.supernode[s + 1].child;
    first[s] = is_leaf ? s : first[structure.child[static_cast<std::size_t>(node.child)]];
  }
  return first;
}

}  // namespace

Schedule::Schedule(const Structure& structure) : update(static_cast<std::size_t>(structure.count()), -1) {
  // Small enough that the last subtree does not keep several threads waiting.
  constexpr double subtrees = 32;
  const auto node = [&](int s) -> const Supernode& { return structure.supernode[s]; };
  double total = 0;
  for (int s = 0; s < structure.count(); ++s) {
    if (node(s).parent < 0) total += node(s).subtree_flops;
    most_rows = std::max(most_rows, node(s).rows);
  }
  const auto is_top = [&](int s) { return node(s).subtree_flops > total / subtrees; };
  const std::vector<int> first = first_descendants(structure);
  Pool space;
  for (int s = 0; s < structure.count(); ++s) {
    if (is_top(s)) {
      top.push_back(s);
    } else if (node(s).parent < 0 || is_top(node(s).parent)) {
      subtree.push_back({first[s], s});
      stack = std::max(stack, node(s).stack);
      update[s] = space.take(update_values(node(s)));
    }
  }
  for (const int s : top) {
    update[s] = space.take(update_values(node(s)));
    for (std::int64_t k = node(s).child; k < node(s + 1).child; ++k) {
      const int c = structure.child[static_cast<std::size_t>(k)];
      space.give_back(update[c], update_values(node(c)));
    }
  }
  pool = space.size();
  std::stable_sort(subtree.begin(), subtree.end(), [&](const Subtree& a, const Subtree& b) {
    return node(a.root).subtree_flops > node(b.root).subtree_flops;
  });
}

std::int64_t update_leading(const Supernode& supernode) {
  return padded(supernode.update_rows());
}

std::int64_t update_values(const Supernode& supernode) {
  return update_leading(supernode) * supernode.update_rows();
}

}  // namespace isostretch::cholesky
