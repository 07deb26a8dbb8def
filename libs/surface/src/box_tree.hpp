#pragma once

#include "exact_side.hpp"

#include <cstddef>
#include <vector>

namespace isostretch::mesh {

struct PlaneBox {
  PlanePoint low{}, high{};
  bool meets(const PlaneBox& other) const {
    return low[0] <= other.high[0] && other.low[0] <= high[0] && low[1] <= other.high[1] &&
           other.low[1] <= high[1];
  }
  void include(const PlaneBox& other);
};

// Where the point lies along a curve that fills the box: what is near in the plane is mostly near there.
unsigned long long morton_code(const PlanePoint& point, const PlaneBox& box);

// A binary tree over boxes in the order in which they are given, which should be that of their Morton codes.
class BoxTree {
 public:
  explicit BoxTree(const std::vector<PlaneBox>& boxes);

  // Calls visit(i) for every box i that meets the given one, ascending, until it returns false.
  template <class Visit>
  void query(const PlaneBox& box, const Visit& visit) const {
    if (!levels_.empty()) descend(levels_.size() - 1, 0, box, visit);
  }

 private:
  template <class Visit>
  bool descend(std::size_t level, std::size_t node, const PlaneBox& box, const Visit& visit) const {
    if (!levels_[level][node].meets(box)) return true;
    if (level == 0) return visit(static_cast<int>(node));
    const std::size_t first = 2 * node, below = levels_[level - 1].size();
    return descend(level - 1, first, box, visit) &&
           (first + 1 >= below || descend(level - 1, first + 1, box, visit));
  }

  std::vector<std::vector<PlaneBox>> levels_;  // leaves first; each next one has boxes of two
};

}  // namespace isostretch::mesh
