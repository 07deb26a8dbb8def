#include "elimination_tree.hpp"

#include <isostretch/core/index.hpp>

#include <algorithm>
#include <cstddef>
#include <numeric>

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

// The subtrees of the rows of L, whose leaves say what a column has in common with others: columns come in
// postorder.
class RowSubtrees {
 public:
  explicit RowSubtrees(std::size_t size) : seen_(size, -1), last_leaf_(size, -1), ancestor_(size) {
    std::iota(ancestor_.begin(), ancestor_.end(), 0);
  }

  // Whether column j, whose first descendant is given, is a leaf of the subtree of row i. `common` gets the
  // least common ancestor with the leaf before, -1 where it is the first.
  bool takes_leaf(int i, int j, int first_descendant, int& common) {
    if (first_descendant <= seen_[at(i)]) return false;
    seen_[at(i)] = first_descendant;
    common = last_leaf_[at(i)] < 0 ? -1 : root_of(last_leaf_[at(i)]);
    last_leaf_[at(i)] = j;
    return true;
  }

  void join(int j, int parent) { ancestor_[at(j)] = parent; }

 private:
  // Paths are halved as they are walked.
  int root_of(int j) {
    while (ancestor_[at(j)] != j) j = ancestor_[at(j)] = ancestor_[at(ancestor_[at(j)])];
    return j;
  }

  std::vector<int> seen_, last_leaf_, ancestor_;
};

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

std::vector<int> inverse(const std::vector<int>& order) {
  std::vector<int> position(order.size());
  for (std::size_t p = 0; p < order.size(); ++p) position[order[p]] = static_cast<int>(p);
  return position;
}

std::vector<int> column_counts(const LaterNeighbours& later, const std::vector<int>& post,
                               const std::vector<int>& parent) {
  const int n = static_cast<int>(parent.size());
  const std::vector<int> position_of = inverse(post);
  std::vector<int> count(parent.size()), first_descendant(parent.size(), -1);
  for (int j = 0; j < n; ++j) {
    count[at(j)] = first_descendant[at(j)] == -1 ? 1 : 0;
    for (int i = j; i != -1 && first_descendant[at(i)] == -1; i = parent[at(i)]) first_descendant[at(i)] = j;
  }
  RowSubtrees rows(parent.size());
  for (int j = 0; j < n; ++j) {
    if (parent[at(j)] >= 0) --count[at(parent[at(j)])];
    const std::size_t old = at(post[at(j)]);
    for (int k = later.start[old]; k < later.start[old + 1]; ++k) {
      const int i = position_of[at(later.position[at(k)])];
      int common = -1;
      if (i == j || !rows.takes_leaf(i, j, first_descendant[at(j)], common)) continue;
      ++count[at(j)];
      if (common >= 0) --count[at(common)];
    }
    if (parent[at(j)] >= 0) rows.join(j, parent[at(j)]);
  }
  for (int j = 0; j < n; ++j)
    if (parent[at(j)] >= 0) count[at(parent[at(j)])] += count[at(j)];
  return count;
}

}  // namespace isostretch::cholesky
