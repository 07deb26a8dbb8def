#include "box_tree.hpp"

#include <algorithm>

namespace isostretch::mesh {
namespace {

// A zero between any two bits.
unsigned long long spread_bits(unsigned long long x) {
  x = (x | (x << 16)) & 0x0000FFFF0000FFFFull;
  x = (x | (x << 8)) & 0x00FF00FF00FF00FFull;
  x = (x | (x << 4)) & 0x0F0F0F0F0F0F0F0Full;
  x = (x | (x << 2)) & 0x3333333333333333ull;
  return (x | (x << 1)) & 0x5555555555555555ull;
}

}  // namespace

void PlaneBox::include(const PlaneBox& other) {
  for (std::size_t d = 0; d < 2; ++d) {
    low[d] = std::min(low[d], other.low[d]);
    high[d] = std::max(high[d], other.high[d]);
  }
}

unsigned long long morton_code(const PlanePoint& point, const PlaneBox& box) {
  const double size = std::max(box.high[0] - box.low[0], box.high[1] - box.low[1]);
  if (!(size > 0)) return 0;
  const auto cell = [&](std::size_t d) {
    return spread_bits(static_cast<unsigned long long>((point[d] - box.low[d]) / size * 4294967295.0));
  };
  return cell(0) | (cell(1) << 1);
}

BoxTree::BoxTree(const std::vector<PlaneBox>& boxes) {
  if (boxes.empty()) return;
  levels_.push_back(boxes);
  while (levels_.back().size() > 1) {
    const std::vector<PlaneBox>& below = levels_.back();
    std::vector<PlaneBox> level((below.size() + 1) / 2);
    for (std::size_t i = 0; i < below.size(); ++i) {
      if (i % 2 == 0)
        level[i / 2] = below[i];
      else
        level[i / 2].include(below[i]);
    }
    levels_.push_back(std::move(level));
  }
}

}  // namespace isostretch::mesh
