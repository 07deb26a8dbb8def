#include "report.hpp"

#include "common/newton_report.hpp"
#include "common/threads.hpp"
#include "distortion_statistics.hpp"

#include <isostretch/core/isa.hpp>
#include <isostretch/core/version.hpp>

namespace isostretch::app::parameterize {
namespace {

Json parameters_json(const energies::AnyEnergy& energy) {
  Json json = Json::object();
  for (const auto& parameter : energy.parameters()) json[parameter.name] = parameter.value;
  return json;
}

Json pins_json(const Options& options) {
  Json json = Json::array();
  for (const Pin& pin : options.pins) {
    Json entry{{"vertex", pin.vertex}, {"kind", "hard"}};
    if (pin.target) entry["uv"] = {pin.target->x(), pin.target->y()};
    json.push_back(std::move(entry));
  }
  for (const SoftPin& pin : options.soft_pins)
    json.push_back({{"vertex", pin.vertex},
                    {"kind", "soft"},
                    {"uv", {pin.target.x(), pin.target.y()}},
                    {"weight", pin.weight}});
  return json;
}

Json options_json(const Options& options) {
  const newton::Options& solve = options.newton;
  return {{"initial", options.initial == Initial::input ? "input" : "tutte"},
          {"projection", newton::projection_name(solve.projection)},
          {"gradient_tolerance", solve.gradient_tolerance},
          {"scaled_gradient_tolerance", solve.scaled_gradient_tolerance},
          {"max_iterations", solve.max_iterations},
          {"time_limit", solve.time_limit},
          {"max_expansion", solve.max_expansion},
          {"solver", sparse::backend_name(solve.solver.backend)},
          {"ordering", sparse::ordering_name(solve.solver.ordering)},
          {"keep_normalized", options.keep_normalized},
          {"pins", pins_json(options)}};
}

Json mesh_json(const Domain& domain, const Start& start, const Options& options) {
  return {{"file", options.model.string()},
          {"vertices", domain.input.vertices.rows()},
          {"triangles", domain.input.triangles.rows()},
          {"boundary_loops", domain.boundary_loops},
          {"cut_edges", domain.cut_edges},
          {"uv_points", domain.open.vertices.rows()},
          {"area", start.total_area}};
}

Json seconds_json(const newton::Summary& summary, const PhaseSeconds& phases) {
  Json json{
      {"total", phases.total}, {"read", phases.read}, {"initial", phases.initial}, {"write", phases.write}};
  json.update(phases_json(summary.seconds));
  return json;
}

}  // namespace

ExitCode exit_code(const Solution& solution) {
  if (newton::failed(solution.summary.status) || !solution.flipped.empty()) return ExitCode::solver_failed;
  return solution.summary.converged() ? ExitCode::success : ExitCode::not_converged;
}

std::string verdict(const Solution& solution) {
  std::string text;
  if (!solution.summary.converged())
    text = std::string(newton::status_name(solution.summary.status)) + ": " + solution.summary.message;
  if (!solution.flipped.empty())
    text += (text.empty() ? "" : "; ") + std::to_string(solution.flipped.size()) +
            " triangle(s) of the result are turned over, the first is " + std::to_string(solution.flipped[0]);
  return text.empty() ? "converged, no triangle is turned over" : text + "; the best state is written";
}

mesh::SurfaceMesh textured(const Domain& domain, const Solution& solution) {
  mesh::SurfaceMesh result = domain.input;
  result.uv = solution.uv;
  result.uv_triangles = domain.open.triangles;
  return result;
}

Json summary_json(const Domain& domain, const Start& start, const energies::AnyEnergy& energy,
                  const Solution& solution, const Options& options, const PhaseSeconds& seconds) {
  Json json = solve_json(solution.summary);
  json["soft_pin_energy"] = solution.soft_pin_energy;
  json["flipped"] = solution.flipped.size();
  json["initial_flipped"] = start.flipped;
  json["seconds"] = seconds_json(solution.summary, seconds);
  json["energy_name"] = energy.name();
  json["energy_parameters"] = parameters_json(energy);
  json["distortion"] = distortion_json(distortion_statistics(solution.stretches, start.elements.weights));
  json["mesh"] = mesh_json(domain, start, options);
  json["options"] = options_json(options);
  json["threads"] = thread_count();
  json["instruction_set"] = isa_name(active_isa());
  json["version"] = version_string;
  return json;
}

}  // namespace isostretch::app::parameterize
