#include "common/newton_report.hpp"

#include <isostretch/core/to_text.hpp>

#include <nlohmann/json.hpp>

#include <cstdio>

namespace isostretch::app {

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
  const PhaseTimes times = seconds.phases();
  Json json = Json::object();
  for (const auto& [phase, time] : times.phases()) json[phase] = time;
  return json;
}

}  // namespace isostretch::app
