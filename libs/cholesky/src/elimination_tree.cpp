#include "elimination_tree.hpp"

#include <algorithm>
#include <cstddef>

namespace isostretch::cholesky {
namespace {

// Children of every node as lists: the first, and of every child the next.
struct ChildLists {
  std::vector<int> first, next;

  explicit ChildLists(const std::vector<int>& parent) : first(parent.size(), -1), next(parent.size(), -1) {
    for (std::size_t j = parent.size(); j-- > 0;) {
      if (parent[j] < 0) continue;
      next[j] = first[parent[j]];
      first[parent[j]] = static_cast<int>(j);
    }
  }
};

// Of every position the earlier ones among its neighbours.
struct EarlierNeighbours {
  std::vector<int> start, position;

  explicit EarlierNeighbours(const LaterNeighbours& later) : start(later.start.size(), 0) {
    const int n = static_cast<int>(later.start.size()) - 1;
    for (const int i : later.position) ++start[i + 1];
    for (int j = 0; j < n; ++j) start[j + 1] += start[j];
    position.resize(later.position.size());
    std::vector<int> place(start.begin(), start.end() - 1);
    for (int j = 0; j < n; ++j)
      for (int k = later.start[j]; k < later.start[j + 1]; ++k) position[place[later.position[k]]++] = j;
  }
};

// The sets of the least common ancestors: paths to roots, halved as they are walked.
int root_of(std::vector<int>& ancestor, int j) {
  while (ancestor[j] != j) j = ancestor[j] = ancestor[ancestor[j]];
  return j;
}

}  // namespace

LaterNeighbours later_neighbours(const Pattern& pattern, const std::vector<int>& position_of) {
  LaterNeighbours later;
  later.start.assign(static_cast<std::size_t>(pattern.size) + 1, 0);
  const auto for_each_entry = [&](const auto& visit) {
    for (int j = 0; j < pattern.size; ++j)
      for (int k = pattern.column_start[j]; k < pattern.column_start[j + 1]; ++k) {
        const int a = position_of[j], b = position_of[pattern.row[k]];
        visit(std::min(a, b), std::max(a, b), k);
      }
  };
  for_each_entry([&](int earlier, int, int) { ++later.start[earlier + 1]; });
  for (int j = 0; j < pattern.size; ++j) later.start[j + 1] += later.start[j];
  later.position.resize(static_cast<std::size_t>(later.start.back()));
  later.entry.resize(later.position.size());
  std::vector<int> place(later.start.begin(), later.start.end() - 1);
  for_each_entry([&](int earlier, int position, int entry) {
    later.position[place[earlier]] = position;
    later.entry[place[earlier]++] = entry;
  });
  return later;
}

std::vector<int> elimination_tree(const LaterNeighbours& later) {
  const EarlierNeighbours earlier(later);
  const std::size_t n = later.start.size() - 1;
  std::vector<int> parent(n, -1), ancestor(n, -1);
  for (int j = 0; j < static_cast<int>(n); ++j)
    for (int k = earlier.start[j]; k < earlier.start[j + 1]; ++k)
      for (int i = earlier.position[k]; i != -1 && i != j;) {
        const int next = ancestor[i];
        ancestor[i] = j;
        if (next == -1) parent[i] = j;
        i = next;
      }
  return parent;
}

std::vector<int> postorder(const std::vector<int>& parent) {
  const ChildLists children(parent);
  std::vector<int> order, stack, next(children.first);
  order.reserve(parent.size());
  for (std::size_t root = 0; root < parent.size(); ++root) {
    if (parent[root] >= 0) continue;
    stack.push_back(static_cast<int>(root));
    while (!stack.empty()) {
      const int j = stack.back();
      if (const int child = next[j]; child >= 0) {
        next[j] = children.next[child];
        stack.push_back(child);
      } else {
        order.push_back(j);
        stack.pop_back();
      }
    }
  }
  return order;
}

std::vector<int> column_counts(const LaterNeighbours& later, const std::vector<int>& parent) {
  const int n = static_cast<int>(parent.size());
  // `first`: the first descendant; rows see a leaf of their subtree where it lies beyond all they have seen.
  std::vector<int> count(parent.size()), first(parent.size(), -1), ancestor(parent.size()),
      seen(parent.size(), -1), last_leaf(parent.size(), -1);
  for (int j = 0; j < n; ++j) {
    ancestor[j] = j;
    count[j] = first[j] == -1 ? 1 : 0;
    for (int i = j; i != -1 && first[i] == -1; i = parent[i]) first[i] = j;
  }
  for (int j = 0; j < n; ++j) {
    if (parent[j] >= 0) --count[parent[j]];
    for (int k = later.start[j]; k < later.start[j + 1]; ++k) {
      const int i = later.position[k];
      if (i == j || first[j] <= seen[i]) continue;
      seen[i] = first[j];
      ++count[j];
      if (last_leaf[i] >= 0) --count[root_of(ancestor, last_leaf[i])];
      last_leaf[i] = j;
    }
    if (parent[j] >= 0) ancestor[j] = parent[j];
  }
  for (int j = 0; j < n; ++j)
    if (parent[j] >= 0) count[parent[j]] += count[j];
  return count;
}

}  // namespace isostretch::cholesky
