#pragma once

#include "progress.hpp"

namespace isostretch::sdp_penalty {

// From the minimiser without constraints at x, whose row of the trace is there, to the end of the solve.
void interior_point(Workspace& work, const Options& options, Progress& progress, Vector& x);
void penalty_path(Workspace& work, const Options& options, Progress& progress, Vector& x);
void augmented_lagrangian(Workspace& work, const Options& options, Progress& progress, Vector& x);
void spectral_sdp(Workspace& work, const Options& options, Progress& progress, Vector& x);
void pennon(Workspace& work, const Options& options, Progress& progress, Vector& x);

}  // namespace isostretch::sdp_penalty
