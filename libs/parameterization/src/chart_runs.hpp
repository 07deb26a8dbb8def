#pragma once

#include <isostretch/parameterization/solution.hpp>

#include <vector>

namespace isostretch::parameterization {

// One summary for the minimisations of all charts, as if it had been one: energies add up over the charts,
// counts and seconds over the runs, the gradient norm is the largest, the status that of the first run that
// went worst. The trace has the total energy after every iteration of every run; `chart_of_row` says whose
// each row is.
void combine_runs(const std::vector<Run>& runs, newton::Summary& summary, std::vector<int>& chart_of_row);

}  // namespace isostretch::parameterization
