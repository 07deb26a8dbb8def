#pragma once

// What formulations of inversion-free manipulation other than the convex problem have in common.
#include "recorder.hpp"
#include "unconstrained.hpp"

#include <isostretch/newton/minimize.hpp>
#include <isostretch/newton/objective.hpp>

#include <vector>

namespace isostretch::baselines {

// The elastic term of the convex problem, its soft targets, and its hard ones pinned. The problem must
// outlive it.
newton::Objective elastic_objective(const sdp_penalty::Problem& problem);

// x with the targets where they belong: all of them, or the hard ones alone.
Vector with_all_targets(const sdp_penalty::Problem& problem, Vector x);
Vector with_hard_targets(const sdp_penalty::Problem& problem, Vector x);
std::vector<int> target_nodes(const sdp_penalty::Problem& problem);

// The elements, weighted as the energy of the convex problem weighs them.
assembly::Elements weighted_elements(const sdp_penalty::Problem& problem);

// Newton's method of a formulation, whose iterates go to the recorder. What ends it is the Summary's status,
// stopped_by_callback where the recorder has ended; the counts are added to the recorder's result.
newton::Summary minimize(newton::Objective& objective, Vector& x, newton::Options options,
                         const Options& limits, Recorder& recorder);

// As many iterations as the limits leave; 0: none.
int iterations_left(const Options& options, Recorder& recorder, int otherwise);

}  // namespace isostretch::baselines
