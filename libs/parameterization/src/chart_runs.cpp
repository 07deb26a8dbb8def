#include "chart_runs.hpp"

#include <algorithm>
#include <map>
#include <string>

namespace isostretch::parameterization {
namespace {

// How bad an end is.
int rank(const newton::Summary& summary) {
  return newton::failed(summary.status) ? 2 : summary.converged() ? 0 : 1;
}

}  // namespace

void combine_runs(const std::vector<Run>& runs, newton::Summary& summary, std::vector<int>& chart_of_row) {
  summary = runs.front().summary;
  chart_of_row.assign(summary.trace.size(), runs.front().chart);
  if (runs.size() == 1) return;

  std::map<int, const newton::Summary*> last;  // of every chart
  double energy = 0;                           // of all charts, at the start
  for (const Run& run : runs) {
    if (run.first) energy += run.summary.initial_energy;
    last[run.chart] = &run.summary;
  }
  // Of the runs that ended their chart; earlier ones were superseded.
  const Run* worst = &runs.back();
  for (const Run& run : runs)
    if (last.at(run.chart) == &run.summary && rank(run.summary) > rank(worst->summary)) worst = &run;

  newton::Summary sum;
  sum.initial_energy = energy;
  sum.gradient_inf_norm = 0;
  chart_of_row.clear();
  for (const Run& run : runs) {
    double before = run.summary.initial_energy;
    for (newton::Iteration row : run.summary.trace) {
      energy += row.energy - before;
      before = row.energy;
      if (row.iteration == 0 && !sum.trace.empty()) continue;  // the start again
      row.iteration = static_cast<int>(sum.trace.size());
      row.seconds += sum.seconds.total;
      row.energy = energy;
      sum.trace.push_back(row);
      chart_of_row.push_back(run.chart);
    }
    sum.add_effort(run.summary);
  }
  for (const auto& [chart, end] : last)
    sum.gradient_inf_norm = std::max(sum.gradient_inf_norm, end->gradient_inf_norm);
  sum.energy = energy;
  sum.status = worst->summary.status;
  sum.message = worst->summary.message;
  if (last.size() > 1 && rank(worst->summary) > 0)
    sum.message += " (chart " + std::to_string(worst->chart) + ")";
  summary = std::move(sum);
}

}  // namespace isostretch::parameterization
