#pragma once

#include <limits>
#include <string>
#include <string_view>
#include <vector>

namespace isostretch::sdp_penalty {

enum class Status {
  not_run,
  optimal,     // feasible, and the certified gap is within the tolerance
  iterations,  // max_iterations reached
  callback,    // stopped by the callback
  failed       // rounding or a failed factorization ended it
};

std::string_view status_name(Status status) noexcept;

// One row of the trace. Row 0 is ex-rotated skinning, the minimiser without constraints.
struct Iteration {
  int iteration = 0;
  double seconds = 0;
  double energy = 0;
  double lower_bound = 0;      // on the energy of every feasible x, whatever this iterate is
  double min_eigenvalue = 0;   // of all S_i
  double complementarity = 0;  // mean eigenvalue of Z Y: the interior point's distance from the boundary
  double step = 0;
  int inverted = 0;  // elements with det F <= 0
};

struct Summary {
  Status status = Status::not_run;
  std::string message = "not run";
  int iterations = 0;
  int linear_solves = 0;  // factorizations
  double energy = std::numeric_limits<double>::quiet_NaN();
  double target_energy = std::numeric_limits<double>::quiet_NaN();
  double lower_bound = -std::numeric_limits<double>::infinity();
  // (energy - lower_bound) / max(|energy|, |lower_bound|): no feasible x is better by more than that. Only
  // for a feasible x; NaN otherwise.
  double gap = std::numeric_limits<double>::quiet_NaN();
  double min_eigenvalue = std::numeric_limits<double>::quiet_NaN();
  double min_determinant = std::numeric_limits<double>::quiet_NaN();
  int inverted = 0;
  double seconds = 0;
  // Of `iterations` and `failed`: ten elements (or all) with the largest multipliers, largest first. Where
  // they grow beyond bounds no x is strictly feasible: the ex-rotations there contradict each other.
  std::vector<int> suspects;
  std::vector<Iteration> trace;
};

}  // namespace isostretch::sdp_penalty
