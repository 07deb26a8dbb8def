#include "orient.hpp"

#include <isostretch/core/index.hpp>

#include <algorithm>
#include <numeric>
#include <utility>

namespace isostretch::mesh {
namespace {

// Union-find that knows for every element whether it is turned against its root.
class ParitySets {
 public:
  explicit ParitySets(int count)
      : parent_(static_cast<std::size_t>(count)), turned_(parent_.size(), 0), odd_(parent_.size(), 0) {
    std::iota(parent_.begin(), parent_.end(), 0);
  }

  // Root, and whether i is turned against it.
  std::pair<int, bool> find(int i) {
    bool turned = false;
    for (; parent(i) != i; i = parent(i)) {
      const int up = parent(i);  // path halving: i hangs on its grandparent then
      turned_[at(i)] ^= turned_[at(up)];
      parent_[at(i)] = parent(up);
      turned ^= turned_[at(i)] != 0;
    }
    return {i, turned};
  }

  // The smaller root remains.
  void unite(int i, int j, bool against) {
    auto [a, turned_a] = find(i);
    auto [b, turned_b] = find(j);
    const bool difference = turned_a ^ turned_b ^ against;
    if (a == b) {
      if (difference) odd_[at(a)] = 1;
      return;
    }
    if (a > b) std::swap(a, b);
    parent_[at(b)] = a;
    turned_[at(b)] = difference;
    odd_[at(a)] |= odd_[at(b)];
  }

  bool odd(int root) const { return odd_[at(root)] != 0; }

 private:
  int parent(int i) const { return parent_[at(i)]; }

  std::vector<int> parent_;
  std::vector<char> turned_;  // against the parent; 0 for roots
  std::vector<char> odd_;     // of roots: some cycle turns an element against itself
};

}  // namespace

OrientedPieces oriented_pieces(const Triangles& triangles, const std::vector<Side>& sides) {
  const auto count = static_cast<int>(triangles.rows());
  ParitySets sets(count);
  for_each_edge(sides, [&](const Side* begin, const Side* end) {
    if (end - begin == 2)
      sets.unite(begin[0].triangle, begin[1].triangle, begin[0].reversed == begin[1].reversed);
  });
  OrientedPieces pieces;
  for (int t = 0; t < count; ++t) {
    const auto [root, turned] = sets.find(t);
    pieces.piece.push_back(root);
    pieces.turned.push_back(turned);
    pieces.one_sided.push_back(root == t && sets.odd(t));
  }
  return pieces;
}

}  // namespace isostretch::mesh
