#include "report.hpp"

#include "choice_names.hpp"
#include "common/newton_report.hpp"
#include "common/numbers.hpp"
#include "common/threads.hpp"
#include "distortion_statistics.hpp"

#include <nlohmann/json.hpp>

#include <isostretch/core/isa.hpp>
#include <isostretch/core/version.hpp>
#include <isostretch/mesh/seams.hpp>

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

Json aligned_json(const Options& options) {
  Json json = Json::array();
  for (const AlignedVertices& line : options.aligned)
    json.push_back({{"vertices", line.vertices}, {"kind", line.horizontal ? "horizontal" : "vertical"}});
  return json;
}

Json options_json(const Options& options) {
  const newton::Options& solve = options.newton;
  return {{"initial", name_of(initial_names, options.initial)},
          {"projection", newton::projection_name(solve.projection)},
          {"gradient_tolerance", solve.gradient_tolerance},
          {"scaled_gradient_tolerance", solve.scaled_gradient_tolerance},
          {"max_iterations", solve.max_iterations},
          {"time_limit", solve.time_limit},
          {"max_expansion", solve.max_expansion},
          {"solver", sparse::backend_name(solve.solver.backend)},
          {"ordering", sparse::ordering_name(solve.solver.ordering)},
          {"boundary", name_of(boundary_names, options.boundary)},
          {"corners", options.corners},
          {"aligned", aligned_json(options)},
          {"repair", options.repair},
          {"weld", options.weld ? Json(*options.weld) : Json()},
          {"cut", options.cut},
          {"input_seams", options.input_seams},
          {"holes", name_of(holes_names, options.holes)},
          {"cut_tips", options.cut_tips},
          {"max_distortion", options.max_distortion},
          {"max_cuts", options.max_cuts},
          {"pack", name_of(pack_names, options.pack)},
          {"margin", options.margin},
          {"keep_normalized", options.keep_normalized},
          {"pins", pins_json(options)}};
}

Json mesh_json(const Result& r) {
  return {{"file", r.options.model.string()},
          {"vertices", r.domain.input.vertices.rows()},
          {"triangles", r.domain.input.triangles.rows()},
          {"components", r.domain.components},
          {"boundary_loops", r.domain.boundary_loops},
          {"genus", r.domain.genus < 0 ? Json() : Json(r.domain.genus)},
          {"area", r.start.total_area}};
}

Json repairs_json(const mesh::RepairReport& repairs) {
  return {{"turned", repairs.turned},
          {"degenerate_removed", repairs.degenerate},
          {"duplicates_removed", repairs.duplicates},
          {"vertices_split", repairs.split_vertices}};
}

Json layout_json(const Result& r) {
  return {{"charts", r.start.charts.size()},
          {"uv_points", r.domain.open().vertices.rows()},
          {"cut_edges", r.domain.cut.seams.size()},
          {"cut_length", mesh::seam_length(r.domain.input.vertices, r.domain.cut.seams)},
          {"further_cuts", r.solution.cuts},
          {"packed", r.layout.packed},
          {"uv_per_length", r.layout.scale},
          {"coverage", r.layout.packed ? Json(r.layout.coverage) : Json()}};
}

Json charts_json(const Result& r) {
  Json charts = Json::array();
  for (const Chart& chart : r.start.charts)
    charts.push_back(
        {{"triangles", chart.triangle.size()},
         {"area", mesh::total_weight(chart.rest)},
         {"start", r.options.initial == Initial::input ? "input" : atlas::start_method_name(chart.method)}});
  for (const Run& run : r.solution.runs) {  // the last run of a chart counts
    Json& chart = charts[static_cast<std::size_t>(run.chart)];
    chart["status"] = newton::status_name(run.summary.status);
    chart["iterations"] = run.summary.iterations;
    chart["energy"] = run.summary.energy;
    chart["gradient_inf_norm"] = run.summary.gradient_inf_norm;
  }
  return charts;
}

Json seconds_json(const newton::Summary& summary, const PhaseSeconds& phases) {
  Json json{
      {"total", phases.total}, {"read", phases.read}, {"initial", phases.initial}, {"write", phases.write}};
  json.update(phases_json(summary.seconds));
  return json;
}

bool missed_bound(const Result& r) {
  return r.options.max_distortion > 0 && r.solution.worst_distortion > r.options.max_distortion;
}

}  // namespace

ExitCode exit_code(const Result& r) {
  if (newton::failed(r.solution.summary.status) || !r.layout.flipped.empty()) return ExitCode::solver_failed;
  return r.solution.summary.converged() && !missed_bound(r) ? ExitCode::success : ExitCode::not_converged;
}

std::string verdict(const Result& r) {
  const newton::Summary& summary = r.solution.summary;
  std::vector<std::string> parts;
  if (!summary.converged())
    parts.push_back(std::string(newton::status_name(summary.status)) + ": " + summary.message);
  if (missed_bound(r))
    parts.push_back("the largest distortion is " + exact_text(r.solution.worst_distortion) + ", not " +
                    exact_text(r.options.max_distortion) + ", after " + std::to_string(r.solution.cuts) +
                    " cuts");
  if (!r.layout.flipped.empty())
    parts.push_back(std::to_string(r.layout.flipped.size()) +
                    " triangle(s) of the result are turned over, the first is " +
                    std::to_string(r.layout.flipped[0]));
  if (parts.empty()) return "converged, no triangle is turned over";
  std::string text;
  for (const std::string& part : parts) text += part + "; ";
  return text + "the best state is written";
}

mesh::SurfaceMesh textured(const Result& r) {
  mesh::SurfaceMesh result = r.domain.input;
  result.uv = r.layout.uv;
  result.uv_triangles = r.domain.open().triangles;
  return result;
}

std::string trace_text(const Result& r) {
  return trace_csv(r.solution.summary, "chart", r.solution.chart_of_row);
}

Json summary_json(const Result& r, const PhaseSeconds& seconds) {
  Json json = solve_json(r.solution.summary);
  json["soft_pin_energy"] = r.solution.soft_pin_energy;
  json["flipped"] = r.layout.flipped.size();
  json["initial_flipped"] = r.start.flipped;
  json["seconds"] = seconds_json(r.solution.summary, seconds);
  json["energy_name"] = r.energy.name();
  json["energy_parameters"] = parameters_json(r.energy);
  json["distortion"] = distortion_json(distortion_statistics(r.solution.stretches, r.start.rest.weights));
  json["distortion"]["worst"] = r.solution.worst_distortion;
  json["mesh"] = mesh_json(r);
  json["repairs"] = repairs_json(r.domain.repairs);
  json["layout"] = layout_json(r);
  json["charts"] = charts_json(r);
  json["options"] = options_json(r.options);
  json["threads"] = thread_count();
  json["instruction_set"] = isa_name(active_isa());
  json["version"] = version_string;
  return json;
}

}  // namespace isostretch::app::parameterize
