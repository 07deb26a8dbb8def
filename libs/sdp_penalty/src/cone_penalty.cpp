#include "cone_penalty.hpp"

#include <numeric>

namespace isostretch::sdp_penalty {

ConePenalty::~ConePenalty() = default;

void PenaltyState::resize(std::size_t elements, std::size_t entries) {
  value.resize(elements);
  multiplier.resize(entries);
  curvature.Q.resize(entries);
  curvature.h.resize(entries);
  curvature.active.resize(elements);
}

double PenaltyState::sum() const {
  return std::accumulate(value.begin(), value.end(), 0.0);
}

int PenaltyState::active() const {
  return std::accumulate(curvature.active.begin(), curvature.active.end(), 0);
}

}  // namespace isostretch::sdp_penalty
