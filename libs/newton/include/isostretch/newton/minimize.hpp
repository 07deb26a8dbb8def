#pragma once

#include <isostretch/newton/solver.hpp>

#include <Eigen/Core>

namespace isostretch::newton {

/// Minimises an objective once: Solver::solve() of a solver that is not kept.
Summary minimize(Objective& objective, Vector& x, const Options& options = {},
                 const IterationCallback& callback = {});

/// Minimises as minimize() above does, from a vector of Eigen's own vector, whose memory stays in the
/// caller's code.
inline Summary minimize(Objective& objective, Eigen::VectorXd& x, const Options& options = {},
                        const IterationCallback& callback = {}) {
  Vector positions = x;
  Summary summary = minimize(objective, positions, options, callback);
  x = positions;
  return summary;
}

}  // namespace isostretch::newton
