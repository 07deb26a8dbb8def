#include "unconstrained.hpp"

#include <isostretch/sdp_penalty/solver.hpp>

namespace isostretch::baselines {

Vector skinned(const sdp_penalty::Problem& problem) {
  sdp_penalty::Options options;
  options.method = sdp_penalty::Method::unconstrained;
  Vector x;
  sdp_penalty::solve(problem, x, options);
  return x;
}

}  // namespace isostretch::baselines
