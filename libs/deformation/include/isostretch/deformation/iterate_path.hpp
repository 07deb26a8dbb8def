#pragma once

#include <isostretch/core/vector.hpp>
#include <isostretch/sdp_penalty/summary.hpp>

#include <vector>

namespace isostretch::deformation {

struct Iterate {
  sdp_penalty::Iteration row;
  Vector positions;
};

/// The iterates that pictures of a solve need: the first few, further ones more and more sparsely, and the
/// last.
class IteratePath {
 public:
  void add(const sdp_penalty::Iteration& row, const Vector& positions);

  const std::vector<Iterate>& iterates() const { return iterates_; }
  /// So many of them at most, the first and the last included.
  std::vector<const Iterate*> selection(std::size_t count) const;

 private:
  std::vector<Iterate> iterates_;
  int next_ = 0;             ///< iteration to keep for good
  bool last_stays_ = false;  ///< it is more than the last so far
};

}  // namespace isostretch::deformation
