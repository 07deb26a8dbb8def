#include <isostretch/deformation/iterate_path.hpp>

#include <algorithm>

namespace isostretch::deformation {

void IteratePath::add(const sdp_penalty::Iteration& row, const Vector& positions) {
  if (!iterates_.empty() && !last_stays_) iterates_.pop_back();
  iterates_.push_back({row, positions});
  last_stays_ = row.iteration >= next_;
  if (last_stays_) next_ = row.iteration + 1 + row.iteration / 4;
}

std::vector<const Iterate*> IteratePath::selection(std::size_t count) const {
  std::vector<const Iterate*> chosen;
  const std::size_t all = iterates_.size(), wanted = std::min(count, all);
  for (std::size_t i = 0; i < wanted; ++i)
    chosen.push_back(&iterates_[wanted > 1 ? (i * (all - 1) + (wanted - 1) / 2) / (wanted - 1) : 0]);
  return chosen;
}

}  // namespace isostretch::deformation
