#include "supernode_tree.hpp"

#include "front.hpp"

#include <algorithm>
#include <cstddef>

namespace isostretch::cholesky {
namespace {

using Node = SupernodeTree::Node;
using Children = std::vector<std::vector<int>>;

double trapezoid(double columns, double rows) {
  return columns * rows - columns * (columns - 1) / 2;
}

// Zeros that the columns of the child get in the front of both.
double added_zeros(const Node& child, const Node& parent) {
  return static_cast<double>(child.columns) * (parent.rows - (child.rows - child.columns));
}

bool pays(const Node& child, const Node& parent, const Amalgamation& options) {
  if (child.is_last != parent.is_last) return false;
  const int columns = child.columns + parent.columns;
  const double zeros = child.zeros + parent.zeros + added_zeros(child, parent);
  const double share = zeros / trapezoid(columns, parent.rows + child.columns);
  if (zeros <= 0) return true;
  for (int level = 0; level < 3; ++level)
    if (columns <= options.columns[level]) return share <= options.zeros[level];
  return share <= options.zeros[3];
}

// The columns of the child come first.
void merge(SupernodeTree& tree, Node& child, Node& parent) {
  parent.zeros += child.zeros + added_zeros(child, parent);
  parent.columns += child.columns;
  parent.rows += child.columns;
  tree.next[child.last] = parent.first;
  parent.first = child.first;
  child.merged = true;
}

Children children_of(const SupernodeTree& tree) {
  Children children(tree.node.size());
  for (std::size_t s = 0; s < tree.node.size(); ++s)
    if (!tree.node[s].merged && tree.node[s].parent >= 0)
      children[tree.node[s].parent].push_back(static_cast<int>(s));
  return children;
}

}  // namespace

SupernodeTree fundamental_supernodes(const std::vector<int>& parent, const std::vector<int>& count,
                                     const std::vector<bool>& is_last) {
  const int n = static_cast<int>(parent.size());
  SupernodeTree tree;
  tree.next.assign(parent.size(), -1);
  std::vector<int> node_of(parent.size());
  for (int j = 0; j < n; ++j) {
    const bool goes_on =
        j > 0 && parent[j - 1] == j && count[j] == count[j - 1] - 1 && is_last[j] == is_last[j - 1];
    if (!goes_on) tree.node.push_back({0, count[j], -1, j, j, 0, is_last[j], false});
    Node& node = tree.node.back();
    if (goes_on) tree.next[node.last] = j;
    node.last = j;
    ++node.columns;
    node_of[j] = static_cast<int>(tree.node.size()) - 1;
  }
  for (Node& node : tree.node)
    if (parent[node.last] >= 0) node.parent = node_of[parent[node.last]];
  return tree;
}

void merge_supernodes(SupernodeTree& tree, const Amalgamation& options) {
  Children children = children_of(tree);
  for (std::size_t s = 0; s < tree.node.size(); ++s) {
    Node& node = tree.node[s];
    std::vector<int>& own = children[s];
    std::stable_sort(own.begin(), own.end(), [&](int a, int b) {
      return added_zeros(tree.node[a], node) < added_zeros(tree.node[b], node);
    });
    std::vector<int> left;
    for (const int c : own) {
      if (!pays(tree.node[c], node, options)) {
        left.push_back(c);
        continue;
      }
      merge(tree, tree.node[c], node);
      for (const int grandchild : children[c]) {
        tree.node[grandchild].parent = static_cast<int>(s);
        left.push_back(grandchild);
      }
    }
    own = std::move(left);
  }
}

std::vector<int> order_of_small_stack(const SupernodeTree& tree) {
  Children children = children_of(tree);
  std::vector<double> peak(tree.node.size()), left(tree.node.size());
  // Children have smaller numbers, also where they were inherited.
  for (std::size_t s = 0; s < tree.node.size(); ++s) {
    const Node& node = tree.node[s];
    if (node.merged) continue;
    std::vector<int>& own = children[s];
    std::stable_sort(own.begin(), own.end(),
                     [&](int a, int b) { return peak[a] - left[a] > peak[b] - left[b]; });
    double held = 0;
    for (const int c : own) {
      peak[s] = std::max(peak[s], held + peak[c]);
      held += left[c];
    }
    const int rows = node.rows - node.columns;
    left[s] = static_cast<double>(trapezoid_values(rows, rows));
    peak[s] = std::max(peak[s], held + left[s]);
  }
  std::vector<int> order, stack;
  std::vector<std::size_t> done(tree.node.size(), 0);
  for (std::size_t root = 0; root < tree.node.size(); ++root) {
    if (tree.node[root].merged || tree.node[root].parent >= 0) continue;
    stack.push_back(static_cast<int>(root));
    while (!stack.empty()) {
      const int s = stack.back();
      if (done[s] < children[s].size()) {
        stack.push_back(children[s][done[s]++]);
      } else {
        order.push_back(s);
        stack.pop_back();
      }
    }
  }
  return order;
}

}  // namespace isostretch::cholesky
