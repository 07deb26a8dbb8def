#include "elimination_tree.hpp"
#include "front.hpp"
#include "supernode_tree.hpp"

#include <isostretch/cholesky/analysis.hpp>
#include <isostretch/core/error.hpp>

#include <algorithm>
#include <limits>
#include <numeric>
#include <string>
#include <utility>

namespace isostretch::cholesky {
namespace {

void require_valid(const Pattern& pattern, std::span<const int> order) {
  const auto fail = [](const std::string& text) { throw Error(ErrorKind::misuse, "cholesky: " + text); };
  if (pattern.size < 0) fail("the size is negative");
  for (int j = 0; j < pattern.size; ++j) {
    if (pattern.column_start[j] > pattern.column_start[j + 1])
      fail("column " + std::to_string(j) + " ends before it begins");
    bool diagonal = false;
    for (int k = pattern.column_start[j]; k < pattern.column_start[j + 1]; ++k) {
      if (pattern.row[k] < j || pattern.row[k] >= pattern.size)
        fail("column " + std::to_string(j) + " has row " + std::to_string(pattern.row[k]) +
             ", which is not in the lower triangle");
      diagonal |= pattern.row[k] == j;
    }
    if (!diagonal) fail("column " + std::to_string(j) + " has no diagonal entry");
  }
  if (order.empty()) return;
  if (order.size() != static_cast<std::size_t>(pattern.size))
    fail("the order has another size than the pattern");
  std::vector<bool> taken(order.size(), false);
  for (const int unknown : order) {
    if (unknown < 0 || unknown >= pattern.size || taken[unknown])
      fail("the order is none: unknown " + std::to_string(unknown));
    taken[unknown] = true;
  }
}

std::vector<int> composed(const std::vector<int>& order, const std::vector<int>& of) {
  std::vector<int> result(of.size());
  for (std::size_t p = 0; p < of.size(); ++p) result[p] = order[of[p]];
  return result;
}

std::vector<int> renumbered(const std::vector<int>& parent, const std::vector<int>& order) {
  const std::vector<int> position = inverse(order);
  std::vector<int> result(parent.size());
  for (std::size_t p = 0; p < order.size(); ++p)
    result[p] = parent[order[p]] < 0 ? -1 : position[parent[order[p]]];
  return result;
}

// Fills a Structure, supernode by supernode. Neighbours are numbered by an order of their own, of which
// position p of the tree is position post[p].
class StructureBuilder {
 public:
  StructureBuilder(const SupernodeTree& tree, const std::vector<int>& order_of_nodes,
                   const LaterNeighbours& later, const std::vector<int>& post)
      : later_(later) {
    number(tree, order_of_nodes, post);
    position_of_ = inverse(old_);
    std::int64_t rows = 0;
    for (int s = 0; s < count_; ++s) rows += structure_.supernode[s].update_rows();
    structure_.row.reserve(static_cast<std::size_t>(rows));
    structure_.entry.reserve(later.entry.size());
    list_children();
    place_.assign(old_.size(), -1);
    for (int s = 0; s < count_; ++s) add(s);
    structure_.place_in_parent.resize(structure_.row.size());
    for (int s = 0; s < count_; ++s) link(s);
    find_runs();
    measure();
  }

  // Unknowns by position, given those of the neighbours' order.
  void name_unknowns(const std::vector<int>& order) { structure_.order = composed(order, old_); }

  Structure take() { return std::move(structure_); }

 private:
  void number(const SupernodeTree& tree, const std::vector<int>& order_of_nodes,
              const std::vector<int>& post) {
    count_ = static_cast<int>(order_of_nodes.size());
    structure_.supernode.resize(static_cast<std::size_t>(count_) + 1);
    std::vector<int> number_of(tree.node.size(), -1);
    for (int s = 0; s < count_; ++s) number_of[order_of_nodes[s]] = s;
    for (int s = 0; s < count_; ++s) {
      const SupernodeTree::Node& node = tree.node[order_of_nodes[s]];
      Supernode& supernode = structure_.supernode[s];
      supernode.first = static_cast<int>(old_.size());
      supernode.columns = node.columns;
      supernode.rows = node.rows;
      supernode.parent = node.parent < 0 ? -1 : number_of[node.parent];
      supernode.is_last = node.is_last;
      for (int j = node.first; j != -1; j = tree.next[j]) old_.push_back(post[j]);
    }
    structure_.supernode.back().first = static_cast<int>(old_.size());
  }

  // Children stand before their parents, and so do their lists.
  void list_children() {
    std::vector<std::int64_t> place(static_cast<std::size_t>(count_) + 1, 0);
    for (int s = 0; s < count_; ++s)
      if (const int parent = structure_.supernode[s].parent; parent >= 0) ++place[parent + 1];
    for (int s = 0; s < count_; ++s) place[s + 1] += place[s];
    for (int s = 0; s <= count_; ++s) structure_.supernode[s].child = place[s];
    structure_.child.resize(static_cast<std::size_t>(place[count_]));
    for (int s = 0; s < count_; ++s)
      if (const int parent = structure_.supernode[s].parent; parent >= 0)
        structure_.child[static_cast<std::size_t>(place[parent]++)] = s;
  }

  std::span<const int> children(int s) const {
    const std::int64_t begin = structure_.supernode[s].child, end = structure_.supernode[s + 1].child;
    return {structure_.child.data() + begin, static_cast<std::size_t>(end - begin)};
  }

  // Calls visit(position, place among the neighbours) for all later neighbours of a position.
  template <class Visit>
  void for_later(int position, const Visit& visit) const {
    for (int k = later_.start[old_[position]]; k < later_.start[old_[position] + 1]; ++k)
      visit(position_of_[later_.position[k]], k);
  }

  // Rows, values and children of a supernode, all of whose children are there.
  void add(int s) {
    Supernode& node = structure_.supernode[s];
    node.row = static_cast<std::int64_t>(structure_.row.size());
    node.values = structure_.values;
    node.leading = padded(node.rows);
    const std::int64_t values = trapezoid_values(node.rows, node.columns);
    if (values > std::numeric_limits<std::uint32_t>::max())
      throw Error(ErrorKind::resource,
                  "cholesky: a front of " + std::to_string(node.rows) + " rows is too large");
    structure_.values += values;
    const int end = node.first + node.columns;
    const auto take = [&](int position) {
      if (position < end || place_[position] == s) return;
      place_[position] = s;
      structure_.row.push_back(position);
    };
    for (int j = node.first; j < end; ++j) for_later(j, [&](int position, int) { take(position); });
    for (const int c : children(s)) {
      const Supernode& child = structure_.supernode[c];
      for (int i = 0; i < child.update_rows(); ++i)
        take(structure_.row[static_cast<std::size_t>(child.row + i)]);
    }
    std::sort(structure_.row.begin() + node.row, structure_.row.end());
  }

  // Where entries of A and rows of the children stand in the front.
  void link(int s) {
    Supernode& node = structure_.supernode[s];
    const int end = node.first + node.columns;
    for (int i = 0; i < node.columns; ++i) place_[node.first + i] = i;
    for (int i = 0; i < node.update_rows(); ++i)
      place_[structure_.row[static_cast<std::size_t>(node.row + i)]] = node.columns + i;
    node.entry = static_cast<std::int64_t>(structure_.entry.size());
    for (int j = node.first; j < end; ++j)
      for_later(j, [&](int position, int k) {
        structure_.entry.push_back(
            {later_.entry[k],
             static_cast<std::uint32_t>(column_place(node.leading, j - node.first) + place_[position])});
      });
    for (const int c : children(s)) {
      const Supernode& child = structure_.supernode[c];
      for (std::int64_t i = child.row; i < child.row + child.update_rows(); ++i)
        structure_.place_in_parent[static_cast<std::size_t>(i)] =
            place_[structure_.row[static_cast<std::size_t>(i)]];
    }
  }

  // After the parents of all are linked.
  void find_runs() {
    for (int s = 0; s < count_; ++s) {
      Supernode& node = structure_.supernode[s];
      node.run = static_cast<std::int64_t>(structure_.run.size());
      if (node.parent < 0) continue;
      const int* where = structure_.place_in_parent.data() + node.row;
      for (int i = 0; i < node.update_rows(); ++i)
        if (i > 0 && where[i] == where[i - 1] + 1)
          ++structure_.run.back().length;
        else
          structure_.run.push_back({i, where[i], 1});
    }
    structure_.supernode.back().run = static_cast<std::int64_t>(structure_.run.size());
  }

  void measure() {
    Supernode& end = structure_.supernode.back();
    end.row = static_cast<std::int64_t>(structure_.row.size());
    end.values = structure_.values;
    end.entry = static_cast<std::int64_t>(structure_.entry.size());
    for (int s = 0; s < count_; ++s) {
      Supernode& node = structure_.supernode[s];
      for (int j = 0; j < node.columns; ++j) node.subtree_flops += double(node.rows - j) * (node.rows - j);
      std::int64_t held = 0;
      for (std::int64_t k = node.child; k < structure_.supernode[s + 1].child; ++k) {
        const Supernode& child = structure_.supernode[structure_.child[static_cast<std::size_t>(k)]];
        node.subtree_flops += child.subtree_flops;
        node.stack = std::max(node.stack, held + child.stack);
        held += trapezoid_values(child.update_rows(), child.update_rows());
      }
      node.stack = std::max(node.stack, held + trapezoid_values(node.update_rows(), node.update_rows()));
    }
  }

  Structure structure_;
  const LaterNeighbours& later_;
  std::vector<int> old_, position_of_;  // position -> position in the neighbours' order, and back
  std::vector<int> place_;
  int count_ = 0;
};

}  // namespace

Analysis::Analysis() {
  structure_.supernode.resize(1);
}

Analysis::Analysis(const Pattern& pattern, std::span<const int> order, const Amalgamation& merge, int last) {
  require_valid(pattern, order);
  if (last < 0 || last > pattern.size)
    throw Error(ErrorKind::misuse, "cholesky: " + std::to_string(last) + " unknowns cannot be the last of " +
                                       std::to_string(pattern.size));
  std::vector<int> column_order(order.begin(), order.end());
  if (order.empty()) {
    column_order.resize(static_cast<std::size_t>(pattern.size));
    std::iota(column_order.begin(), column_order.end(), 0);
  }
  last_.assign(column_order.end() - last, column_order.end());
  const LaterNeighbours later = later_neighbours(pattern, inverse(column_order));
  std::vector<int> parent = elimination_tree(later);
  const std::vector<int> post = postorder(parent);
  parent = renumbered(parent, post);
  const std::vector<int> count = column_counts(later, post, parent);
  for (const int entries : count) {
    factor_nonzeros_ += entries;
    factor_flops_ += double(entries) * entries;
  }
  std::vector<bool> is_last(post.size());
  for (std::size_t p = 0; p < post.size(); ++p) is_last[p] = post[p] >= pattern.size - last;
  SupernodeTree tree = fundamental_supernodes(parent, count, is_last);
  merge_supernodes(tree, merge);
  StructureBuilder builder(tree, order_of_small_stack(tree), later, post);
  builder.name_unknowns(column_order);
  structure_ = builder.take();
}

}  // namespace isostretch::cholesky
