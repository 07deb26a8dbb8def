#include "report.hpp"

#include "common/newton_report.hpp"
#include "common/scene_input.hpp"
#include "common/threads.hpp"

#include <isostretch/core/isa.hpp>
#include <isostretch/core/text.hpp>
#include <isostretch/core/to_text.hpp>
#include <isostretch/core/version.hpp>
#include <isostretch/parameterization/distortion_statistics.hpp>
#include <isostretch/scene/option_values.hpp>
#include <isostretch/surface/seams.hpp>

#include <nlohmann/json.hpp>

#include <map>

namespace isostretch::app::parameterize {
namespace {

Json parameters_json(const energies::AnyEnergy& energy) {
  Json json = Json::object();
  for (const auto& parameter : energy.parameters()) json[parameter.name] = parameter.value;
  return json;
}

Json distortion_json(const parameterization::DistortionStatistics& s) {
  return {{"min_sigma", s.min_sigma},
          {"mean_sigma", s.mean_sigma},
          {"max_sigma", s.max_sigma},
          {"mean_area_ratio", s.mean_area_ratio},
          {"mean_sigma_ratio", s.mean_sigma_ratio},
          {"max_sigma_ratio", s.max_sigma_ratio}};
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
  Json json = report_json(scene::options_value<parameterization::Options>(options));
  json["uv_units"] = name_of(choice_names(options.uv_units), options.units());
  json["corners"] = options.corners;
  json["aligned"] = aligned_json(options);
  json["pins"] = pins_json(options);
  json["repair"] = options.repair;
  json["weld"] = options.weld ? Json(*options.weld) : Json();
  return json;
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

Json overlap_json(const Result& r) {
  const mesh::Overlap& overlap = r.layout.overlap;
  Json json{{"share", overlap.share()},
            {"area", overlap.overlapped_area},
            {"triangles", overlap.triangles.size()},
            {"charts", charts_concerned(r.domain, overlap)}};
  if (r.split.done)
    json["split"] = {{"share_before", r.split.share_before},
                     {"charts_added", r.split.charts_added},
                     {"cut_length", r.split.cut_length}};
  return json;
}

Json layout_json(const Result& r) {
  return {{"charts", r.start.charts.size()},
          {"uv_points", r.domain.open().vertices.rows()},
          {"cut_edges", r.domain.cut.seams.size()},
          {"cut_length", mesh::seam_length(r.domain.input.vertices, r.domain.cut.seams)},
          {"further_cuts", r.solution.cuts},
          {"packed", r.layout.packed},
          {"uv_per_length", r.layout.scale},
          {"coverage", r.layout.packed ? Json(r.layout.coverage) : Json()},
          {"overlap", overlap_json(r)}};
}

Json charts_json(const Result& r) {
  Json charts = Json::array();
  for (const Chart& chart : r.start.charts)
    charts.push_back(
        {{"triangles", chart.triangle.size()},
         {"area", mesh::total_weight(chart.rest)},
         {"start", r.options.initial == Initial::input ? "input"
                                                       : parameterization::start_method_name(chart.method)}});
  // The last run of a chart counts. What it says of energies holds of all parts together.
  std::map<int, const newton::Summary*> last;
  for (const Run& run : r.solution.runs) last[run.chart] = &run.summary;
  std::map<int, int> parts;
  for (const Chart& chart : r.start.charts) ++parts[chart.solved_as];
  for (std::size_t c = 0; c < charts.size(); ++c) {
    const int solved_as = r.start.charts[c].solved_as;
    const newton::Summary& run = *last.at(solved_as < 0 ? static_cast<int>(c) : solved_as);
    charts[c]["status"] = newton::status_name(run.status);
    charts[c]["iterations"] = run.iterations;
    if (solved_as >= 0) charts[c]["split_from"] = solved_as;
    if (solved_as >= 0 && parts[solved_as] > 1) continue;
    charts[c]["energy"] = run.energy;
    charts[c]["gradient_inf_norm"] = run.gradient_inf_norm;
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
  if (!summary.converged()) parts.push_back("not converged: " + summary.message);
  if (missed_bound(r))
    parts.push_back("the largest distortion is " + formatted("%.4g", r.solution.worst_distortion) + ", not " +
                    to_text(r.options.max_distortion) + ", after " + std::to_string(r.solution.cuts) +
                    " cuts");
  if (!r.layout.flipped.empty())
    parts.push_back(std::to_string(r.layout.flipped.size()) +
                    " triangle(s) of the result are turned over, the first is " +
                    std::to_string(r.layout.flipped[0]));
  if (parts.empty()) return "";
  std::string text;
  for (const std::string& part : parts) text += part + "; ";
  return text + "the best state is written";
}

std::string trace_text(const Result& r) {
  Trace trace = newton::trace_table(r.solution.summary);
  trace.add_column("chart", {r.solution.chart_of_row.begin(), r.solution.chart_of_row.end()});
  return to_csv(trace);
}

Json summary_json(const Result& r, const PhaseSeconds& seconds) {
  Json json = solve_json(r.solution.summary);
  json["soft_pin_energy"] = r.solution.soft_pin_energy;
  json["flipped"] = r.layout.flipped.size();
  json["initial_flipped"] = r.start.flipped;
  json["seconds"] = seconds_json(r.solution.summary, seconds);
  json["energy_name"] = r.energy.name();
  json["energy_parameters"] = parameters_json(r.energy);
  json["distortion"] =
      distortion_json(parameterization::distortion_statistics(r.solution.stretches, r.start.rest.weights));
  json["distortion"]["worst"] = r.solution.worst_distortion;
  json["mesh"] = mesh_json(r);
  json["repairs"] = repairs_json(r.input.repairs);
  json["layout"] = layout_json(r);
  json["charts"] = charts_json(r);
  json["options"] = options_json(r.options);
  json["threads"] = thread_count();
  json["instruction_set"] = isa_name(active_isa());
  json["version"] = version_string;
  return json;
}

}  // namespace isostretch::app::parameterize
