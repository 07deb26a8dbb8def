#pragma once

#include <isostretch/core/vector.hpp>
#include <isostretch/newton/objective.hpp>
#include <isostretch/newton/options.hpp>
#include <isostretch/newton/summary.hpp>

#include <Eigen/Core>

#include <functional>

namespace isostretch::newton {

enum class CallbackAction { proceed, stop };

// Called after the start and after every iteration with the row just added to the trace and the positions. A
// callback may take them as an Eigen::VectorXd: they are copied then.
using IterationCallback = std::function<CallbackAction(const Iteration&, const Vector& x)>;

// Projected Newton: minimises the objective from x (dim * node_count entries, node by node), which ends as
// the best positions found, also when the solve fails or is stopped; the energy never rises. Throws Error for
// misuse (sizes, options); numerical outcomes are the Summary's status.
Summary minimize(Objective& objective, Vector& x, const Options& options = {},
                 const IterationCallback& callback = {});

// The same from Eigen's own vector, whose memory stays in the caller's code.
inline Summary minimize(Objective& objective, Eigen::VectorXd& x, const Options& options = {},
                        const IterationCallback& callback = {}) {
  Vector positions = x;
  Summary summary = minimize(objective, positions, options, callback);
  x = positions;
  return summary;
}

}  // namespace isostretch::newton
