#pragma once

#include <isostretch/newton/objective.hpp>
#include <isostretch/newton/options.hpp>
#include <isostretch/newton/summary.hpp>

#include <Eigen/Core>

#include <functional>

namespace isostretch::newton {

enum class CallbackAction { proceed, stop };

// Called after the start and after every iteration with the row just added to the trace and the positions.
using IterationCallback = std::function<CallbackAction(const Iteration&, const Eigen::VectorXd& x)>;

// Projected Newton: minimises the objective from x (dim * node_count entries, node by node), which ends as
// the best positions found, also when the solve fails or is stopped; the energy never rises. Throws Error for
// misuse (sizes, options); numerical outcomes are the Summary's status.
Summary minimize(Objective& objective, Eigen::VectorXd& x, const Options& options = {},
                 const IterationCallback& callback = {});

}  // namespace isostretch::newton
