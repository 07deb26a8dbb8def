#pragma once

#include <isostretch/baselines/distortion.hpp>

namespace isostretch::baselines {

// Shear modulus of the energy at rest, half of the flip eigenvalue there; 1 where that is not positive, or
// the energy not finite.
double shear_at_rest(const DistortionProblem& problem);

}  // namespace isostretch::baselines
