#include "json.hpp"

#include <isostretch/core/text.hpp>
#include <isostretch/core/to_text.hpp>

namespace isostretch::reports {

Json json_of(const newton::Summary& summary) {
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

Json json_of(const newton::Seconds& seconds) {
  const PhaseTimes times = seconds.phases();
  Json json = Json::object();
  for (const auto& [phase, time] : times.phases()) json[phase] = time;
  return json;
}

Json json_of(const scene::Value& value) {
  return Json::parse(scene::to_json(value));
}

Json parameters_of(const energies::AnyEnergy& energy) {
  Json json = Json::object();
  for (const auto& parameter : energy.parameters()) json[parameter.name] = parameter.value;
  return json;
}

std::string file_text(const Json& json) {
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string number(const Json& value, const char* pattern) {
  return value.is_number() ? formatted(pattern, value.get<double>()) : std::string("–");
}

std::string trace_rows(const newton::Summary& summary, int frame, bool head) {
  Trace trace = newton::trace_table(summary);
  trace.add_column("frame", std::vector<double>(trace.rows.size(), frame));
  const std::string text = to_csv(trace);
  return head ? text : text.substr(text.find('\n') + 1);
}

}  // namespace isostretch::reports
