#pragma once

#include "recorder.hpp"

namespace isostretch::baselines {

// Ipopt (Waechter, Biegler 2006) on the principal minors, from the minimiser without constraints.
Vector run_ipopt(const Instance& instance, const Options& options, Recorder& recorder);
// From a strictly feasible position, which it looks for itself: the time is one of modelling.
Vector run_ipopt_feasible(const Instance& instance, const Options& options, Recorder& recorder);
// On the second-order cones of 2D.
Vector run_ipopt_cone(const Instance& instance, const Options& options, Recorder& recorder);

}  // namespace isostretch::baselines
