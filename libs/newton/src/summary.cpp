#include <isostretch/newton/summary.hpp>

#include <algorithm>
#include <cstdio>

namespace isostretch::newton {
namespace {

template <class... Arguments>
std::string format(const char* pattern, Arguments... arguments) {
  char buffer[512];
  std::snprintf(buffer, sizeof buffer, pattern, arguments...);
  return buffer;
}

}  // namespace

std::string_view status_name(Status status) noexcept {
  switch (status) {
    case Status::not_run:
      return "not_run";
    case Status::converged_gradient:
      return "converged_gradient";
    case Status::converged_scaled_gradient:
      return "converged_scaled_gradient";
    case Status::converged_decrement:
      return "converged_decrement";
    case Status::converged_energy:
      return "converged_energy";
    case Status::converged_roundoff:
      return "converged_roundoff";
    case Status::stopped_iterations:
      return "stopped_iterations";
    case Status::stopped_time:
      return "stopped_time";
    case Status::stopped_by_callback:
      return "stopped_by_callback";
    case Status::failed_start:
      return "failed_start";
    case Status::failed_derivatives:
      return "failed_derivatives";
    case Status::failed_factorization:
      return "failed_factorization";
    case Status::failed_line_search:
      return "failed_line_search";
  }
  return "?";
}

bool converged(Status status) noexcept {
  return status == Status::converged_gradient || status == Status::converged_scaled_gradient ||
         status == Status::converged_decrement || status == Status::converged_energy ||
         status == Status::converged_roundoff;
}

bool failed(Status status) noexcept {
  return status == Status::not_run || status == Status::failed_start ||
         status == Status::failed_derivatives || status == Status::failed_factorization ||
         status == Status::failed_line_search;
}

SolveStatus outcome(Status status) noexcept {
  if (converged(status)) return SolveStatus::converged;
  switch (status) {
    case Status::not_run:
      return SolveStatus::not_run;
    case Status::stopped_iterations:
      return SolveStatus::iteration_limit;
    case Status::stopped_time:
      return SolveStatus::time_limit;
    case Status::stopped_by_callback:
      return SolveStatus::interrupted;
    default:
      return SolveStatus::failed;
  }
}

PhaseTimes Seconds::phases() const {
  PhaseTimes times;
  times.add("minimize", total);
  times.add("setup", setup);
  times.add("assembly", assembly);
  times.add("factorization", factorization);
  times.add("solve", solve);
  times.add("line_search", line_search);
  return times;
}

void Summary::add_effort(const Summary& other) {
  iterations += other.iterations;
  factorizations += other.factorizations;
  failed_factorizations += other.failed_factorizations;
  energy_evaluations += other.energy_evaluations;
  factor_nonzeros = std::max(factor_nonzeros, other.factor_nonzeros);
  if (solver.empty()) solver = other.solver;
  seconds.total += other.seconds.total;
  seconds.setup += other.seconds.setup;
  seconds.assembly += other.seconds.assembly;
  seconds.factorization += other.seconds.factorization;
  seconds.solve += other.seconds.solve;
  seconds.line_search += other.seconds.line_search;
}

std::string progress_line(const Iteration& row) {
  return format("iteration %d  energy %.8g  |gradient| %.2e  step %.3g  %.1f s", row.iteration, row.energy,
                row.gradient_inf_norm, row.step, row.seconds);
}

Trace trace_table(const Summary& summary) {
  Trace trace{{"iteration", "seconds", "energy", "gradient_inf_norm", "step", "decrement",
               "projection_weight", "points_filtered", "factorizations", "evaluations"},
              {}};
  for (const Iteration& row : summary.trace)
    trace.rows.push_back({static_cast<double>(row.iteration), row.seconds, row.energy, row.gradient_inf_norm,
                          row.step, row.decrement, row.projection_weight,
                          static_cast<double>(row.points_filtered), static_cast<double>(row.factorizations),
                          static_cast<double>(row.evaluations)});
  return trace;
}

std::string Summary::brief_report() const {
  return format("%s after %d iterations (%d factorizations), %.3f s: energy %.10g, |gradient|_inf %.3g",
                std::string(status_name(status)).c_str(), iterations, factorizations, seconds.total, energy,
                gradient_inf_norm);
}

std::string Summary::full_report() const {
  std::string text = brief_report() + "\n" + message + "\n";
  text += format("energy           %.12g -> %.12g\n", initial_energy, energy);
  text +=
      format("factorizations   %d, %d not positive definite; %s, %.3g nonzeros\n", factorizations,
             failed_factorizations, solver.empty() ? "no solver needed" : solver.c_str(), factor_nonzeros);
  text += format("energy evaluations by the line search: %d\n", energy_evaluations);
  text += format(
      "seconds          total %.4f: setup %.4f, assembly %.4f, factorization %.4f, solve %.4f, line search "
      "%.4f\n",
      seconds.total, seconds.setup, seconds.assembly, seconds.factorization, seconds.solve,
      seconds.line_search);
  text +=
      "  it       energy          |gradient|_inf  step      fit       decrement   filter  filtered  tried\n";
  for (const Iteration& row : trace)
    text += format("%4d  %.14g  %.3e  %.3e  %.2e  %.3e  %.3f  %8zu  %d\n", row.iteration, row.energy,
                   row.gradient_inf_norm, row.step, row.model_fit, row.decrement, row.projection_weight,
                   row.points_filtered, row.factorizations);
  return text;
}

}  // namespace isostretch::newton
