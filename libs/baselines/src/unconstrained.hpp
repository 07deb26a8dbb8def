#pragma once

#include <isostretch/core/vector.hpp>
#include <isostretch/sdp_penalty/problem.hpp>

namespace isostretch::baselines {

// The unconstrained minimiser, where many begin: the minimiser without constraints, with hard targets where
// they belong.
Vector skinned(const sdp_penalty::Problem& problem);

}  // namespace isostretch::baselines
