#pragma once

#include <isostretch/baselines/distortion.hpp>
#include <isostretch/core/timer.hpp>

namespace isostretch::baselines {

// The problem as an objective, with `term` for the energy.
newton::Objective objective_of(const DistortionProblem& problem, std::unique_ptr<newton::Term> term);
newton::Objective objective_of(const DistortionProblem& problem);  // with an EnergyTerm

// What the methods share: the stopping rule, and steps that are never lengthened (ours lengthens them, which
// is no part of the published methods).
newton::Options shared_options(const MethodOptions& options);

// Newton's loop. What passed since `timer` began, making the objective, counts as set-up.
newton::Summary minimize_since(const Timer& timer, newton::Objective& objective, Vector& x,
                               const newton::Options& options, const newton::IterationCallback& callback);

// The same with the Hessians that `term` makes by itself: they are taken as they are.
newton::Summary minimize_with(const Timer& timer, std::unique_ptr<newton::Term> term,
                              const DistortionProblem& problem, Vector& x, const MethodOptions& options,
                              const newton::IterationCallback& callback);

}  // namespace isostretch::baselines
