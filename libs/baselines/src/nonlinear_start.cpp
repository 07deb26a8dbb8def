#include "nonlinear_start.hpp"

#include <isostretch/sdp_penalty/solver.hpp>

namespace isostretch::baselines {

Vector minimiser_without_constraints(const sdp_penalty::Problem& problem) {
  sdp_penalty::Options options;
  options.method = sdp_penalty::Method::skinning;
  Vector x;
  sdp_penalty::solve(problem, x, options);
  return x;
}

}  // namespace isostretch::baselines
