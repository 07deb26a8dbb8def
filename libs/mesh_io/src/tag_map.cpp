#include "tag_map.hpp"

#include <algorithm>
#include <numeric>

namespace isostretch::mesh {

bool TagMap::consecutive() const {
  for (std::size_t i = 1; i < tags_.size(); ++i)
    if (tags_[i - 1] >= tags_[i] || tags_[i] - tags_[i - 1] != 1) return false;
  return true;
}

int TagMap::prepare() {
  table_.clear();
  sorted_.clear();
  if (tags_.empty()) return -1;
  const auto [low, high] = std::minmax_element(tags_.begin(), tags_.end());
  smallest_ = *low;
  span_ = static_cast<std::uint64_t>(*high) - static_cast<std::uint64_t>(*low);
  consecutive_ = consecutive();
  if (consecutive_) return -1;
  return span_ < 4 * tags_.size() ? fill_table() : sort();
}

int TagMap::fill_table() {
  table_.assign(static_cast<std::size_t>(span_) + 1, -1);
  for (std::size_t i = 0; i < tags_.size(); ++i) {
    int& entry = table_[static_cast<std::size_t>(tags_[i] - smallest_)];
    if (entry >= 0) return static_cast<int>(i);
    entry = static_cast<int>(i);
  }
  return -1;
}

int TagMap::sort() {
  sorted_.resize(tags_.size());
  std::iota(sorted_.begin(), sorted_.end(), 0);
  std::stable_sort(sorted_.begin(), sorted_.end(), [this](int a, int b) { return tag(a) < tag(b); });
  const auto equal =
      std::adjacent_find(sorted_.begin(), sorted_.end(), [this](int a, int b) { return tag(a) == tag(b); });
  return equal == sorted_.end() ? -1 : *(equal + 1);
}

int TagMap::find(std::int64_t wanted) const {
  const std::uint64_t offset = static_cast<std::uint64_t>(wanted) - static_cast<std::uint64_t>(smallest_);
  if (tags_.empty() || wanted < smallest_ || offset > span_) return -1;
  if (consecutive_) return static_cast<int>(offset);
  if (!table_.empty()) return table_[static_cast<std::size_t>(offset)];
  const auto found = std::lower_bound(sorted_.begin(), sorted_.end(), wanted,
                                      [this](int position, std::int64_t t) { return tag(position) < t; });
  return found != sorted_.end() && tag(*found) == wanted ? *found : -1;
}

}  // namespace isostretch::mesh
