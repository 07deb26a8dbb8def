#pragma once

#include <isostretch/core/vector.hpp>
#include <isostretch/sdp_penalty/summary.hpp>

#include <vector>

namespace isostretch::deformation {

/// An iterate of a solve.
struct Iterate {
  sdp_penalty::Iteration row;  ///< Numbers of the iteration.
  Vector positions;            ///< Positions, dim entries per node.
};

/// The iterates that pictures of a solve need: the first few, further ones more and more sparsely, and the
/// last.
class IteratePath {
 public:
  /// Adds an iterate, which is kept for good or as the last so far.
  void add(const sdp_penalty::Iteration& row, const Vector& positions);

  /// Returns the iterates that are kept.
  const std::vector<Iterate>& iterates() const { return iterates_; }
  /// Returns at most `count` of the iterates, the first and the last included.
  std::vector<const Iterate*> selection(std::size_t count) const;

 private:
  std::vector<Iterate> iterates_;
  int next_ = 0;             ///< Iteration to keep for good.
  bool last_stays_ = false;  ///< Whether the last is more than the last so far.
};

}  // namespace isostretch::deformation
