#include "common/newton_report.hpp"

#include <isostretch/core/to_text.hpp>

#include <nlohmann/json.hpp>

#include <cstdio>

namespace isostretch::app {

namespace {

constexpr const char* trace_columns =
    "iteration,seconds,energy,gradient_inf_norm,step,decrement,filter_strength,points_filtered,"
    "factorizations,evaluations";

std::string trace_line(const newton::Iteration& row) {
  std::string text = std::to_string(row.iteration);
  for (const double value :
       {row.seconds, row.energy, row.gradient_inf_norm, row.step, row.decrement, row.filter_strength})
    text.append(1, ',').append(to_text(value));
  text.append(1, ',').append(std::to_string(row.points_filtered));
  text.append(1, ',').append(std::to_string(row.factorizations));
  return text.append(1, ',').append(std::to_string(row.evaluations));
}

}  // namespace

std::string trace_csv(const newton::Summary& summary) {
  std::string text = std::string(trace_columns) + '\n';
  for (const newton::Iteration& row : summary.trace) text.append(trace_line(row)).append(1, '\n');
  return text;
}

std::string trace_csv(const newton::Summary& summary, const std::string& name,
                      const std::vector<int>& column) {
  std::string text = std::string(trace_columns) + ',' + name + '\n';
  for (std::size_t i = 0; i < summary.trace.size(); ++i)
    text.append(trace_line(summary.trace[i])).append(1, ',').append(std::to_string(column.at(i))) += '\n';
  return text;
}

Json solve_json(const newton::Summary& summary) {
  return {{"status", newton::status_name(summary.status)},
          {"converged", summary.converged()},
          {"message", summary.message},
          {"iterations", summary.iterations},
          {"factorizations", summary.factorizations},
          {"failed_factorizations", summary.failed_factorizations},
          {"energy_evaluations", summary.energy_evaluations},
          {"initial_energy", summary.initial_energy},
          {"energy", summary.energy},
          {"gradient_inf_norm", summary.gradient_inf_norm},
          {"solver", summary.solver},
          {"factor_nonzeros", summary.factor_nonzeros}};
}

Json phases_json(const newton::Seconds& seconds) {
  return {{"minimize", seconds.total},    {"setup", seconds.setup},
          {"assembly", seconds.assembly}, {"factorization", seconds.factorization},
          {"solve", seconds.solve},       {"line_search", seconds.line_search}};
}

std::string progress_line(const newton::Iteration& row) {
  char line[128];
  std::snprintf(line, sizeof line, "iteration %d  energy %.8g  |gradient| %.2e  step %.3g  %.1f s",
                row.iteration, row.energy, row.gradient_inf_norm, row.step, row.seconds);
  return line;
}

}  // namespace isostretch::app
