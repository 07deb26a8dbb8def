#pragma once

#include <isostretch/baselines/distortion.hpp>

#include <initializer_list>
#include <string>
#include <string_view>

namespace isostretch::baselines {

// Reasons for Method::why_not_applicable; empty where there is none.
std::string needs_dimension(const DistortionProblem& problem, int dim);
std::string needs_energy(const DistortionProblem& problem, std::initializer_list<std::string_view> energies);
std::string needs_barrier(const DistortionProblem& problem);

}  // namespace isostretch::baselines
