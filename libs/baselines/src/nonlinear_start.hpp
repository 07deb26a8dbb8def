#pragma once

#include <isostretch/core/vector.hpp>
#include <isostretch/sdp_penalty/problem.hpp>

namespace isostretch::baselines {

// Where solvers of nonlinear programs start: the minimiser without constraints, with hard targets where they
// belong.
Vector minimiser_without_constraints(const sdp_penalty::Problem& problem);

}  // namespace isostretch::baselines
