#pragma once

#include "recorder.hpp"

namespace isostretch::baselines {

// Algorithms of NLopt (Johnson) on the principal minors, from the minimiser without constraints.
Vector run_nlopt_mma(const Instance& instance, const Options& options, Recorder& recorder);
Vector run_nlopt_ccsaq(const Instance& instance, const Options& options, Recorder& recorder);
Vector run_nlopt_slsqp(const Instance& instance, const Options& options, Recorder& recorder);
Vector run_nlopt_auglag(const Instance& instance, const Options& options, Recorder& recorder);

}  // namespace isostretch::baselines
