#include <isostretch/reports/parameterization_report.hpp>

#include "parameterization_summary.hpp"

#include <isostretch/core/isa.hpp>
#include <isostretch/core/text.hpp>
#include <isostretch/core/to_text.hpp>
#include <isostretch/core/version.hpp>
#include <isostretch/parameterization/distortion_statistics.hpp>
#include <isostretch/scene/option_values.hpp>
#include <isostretch/surface/seams.hpp>

#include <map>

namespace isostretch::reports {
namespace {

using Result = ParameterizationReport;

Json distortion_json(const parameterization::DistortionStatistics& s) {
  return {{"min_sigma", s.min_sigma},
          {"mean_sigma", s.mean_sigma},
          {"max_sigma", s.max_sigma},
          {"mean_area_ratio", s.mean_area_ratio},
          {"mean_sigma_ratio", s.mean_sigma_ratio},
          {"max_sigma_ratio", s.max_sigma_ratio}};
}

Json pins_json(const parameterization::Options& options) {
  Json json = Json::array();
  for (const parameterization::Pin& pin : options.pins) {
    Json entry{{"vertex", pin.vertex}, {"kind", "hard"}};
    if (pin.target) entry["uv"] = {pin.target->x(), pin.target->y()};
    json.push_back(std::move(entry));
  }
  for (const parameterization::SoftPin& pin : options.soft_pins)
    json.push_back({{"vertex", pin.vertex},
                    {"kind", "soft"},
                    {"uv", {pin.target.x(), pin.target.y()}},
                    {"weight", pin.weight}});
  return json;
}

Json aligned_json(const parameterization::Options& options) {
  Json json = Json::array();
  for (const parameterization::AlignedVertices& line : options.aligned)
    json.push_back({{"vertices", line.vertices}, {"kind", line.horizontal ? "horizontal" : "vertical"}});
  return json;
}

Json options_json(const Result& r) {
  const parameterization::Options& options = r.options;
  Json json = json_of(scene::options_value<parameterization::Options>(options));
  json["uv_units"] = name_of(choice_names(options.uv_units), options.units());
  json["corners"] = options.corners;
  json["aligned"] = aligned_json(options);
  json["pins"] = pins_json(options);
  json["repair"] = r.repair;
  json["weld"] = r.weld ? Json(*r.weld) : Json();
  return json;
}

Json mesh_json(const Result& r) {
  return {{"file", r.model.string()},
          {"vertices", r.result.domain.input.vertices.rows()},
          {"triangles", r.result.domain.input.triangles.rows()},
          {"components", r.result.domain.components},
          {"boundary_loops", r.result.domain.boundary_loops},
          {"genus", r.result.domain.genus < 0 ? Json() : Json(r.result.domain.genus)},
          {"area", r.result.start.total_area}};
}

Json repairs_json(const mesh::RepairReport& repairs) {
  return {{"turned", repairs.turned},
          {"degenerate_removed", repairs.degenerate},
          {"duplicates_removed", repairs.duplicates},
          {"vertices_split", repairs.split_vertices}};
}

Json overlap_json(const Result& r) {
  const mesh::Overlap& overlap = r.result.layout.overlap;
  Json json{{"share", overlap.share()},
            {"area", overlap.overlapped_area},
            {"triangles", overlap.triangles.size()},
            {"charts", parameterization::charts_concerned(r.result.domain, overlap)}};
  if (r.result.split.done)
    json["split"] = {{"share_before", r.result.split.share_before},
                     {"charts_added", r.result.split.charts_added},
                     {"cut_length", r.result.split.cut_length}};
  return json;
}

Json layout_json(const Result& r) {
  return {{"charts", r.result.start.charts.size()},
          {"uv_points", r.result.domain.open().vertices.rows()},
          {"cut_edges", r.result.domain.cut.seams.size()},
          {"cut_length", mesh::seam_length(r.result.domain.input.vertices, r.result.domain.cut.seams)},
          {"further_cuts", r.result.solution.cuts},
          {"packed", r.result.layout.packed},
          {"uv_per_length", r.result.layout.scale},
          {"coverage", r.result.layout.packed ? Json(r.result.layout.coverage) : Json()},
          {"overlap", overlap_json(r)}};
}

Json charts_json(const Result& r) {
  Json charts = Json::array();
  for (const parameterization::Chart& chart : r.result.start.charts)
    charts.push_back({{"triangles", chart.triangle.size()},
                      {"area", mesh::total_weight(chart.rest)},
                      {"start", r.options.initial == parameterization::Initial::input
                                    ? "input"
                                    : parameterization::start_method_name(chart.method)}});
  // The last run of a chart counts. What it says of energies holds of all parts together.
  std::map<int, const newton::Summary*> last;
  for (const parameterization::Run& run : r.result.solution.runs) last[run.chart] = &run.summary;
  std::map<int, int> parts;
  for (const parameterization::Chart& chart : r.result.start.charts) ++parts[chart.solved_as];
  for (std::size_t c = 0; c < charts.size(); ++c) {
    const int solved_as = r.result.start.charts[c].solved_as;
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

Json seconds_json(const newton::Summary& summary, const RunFacts& phases) {
  Json json{
      {"total", phases.total}, {"read", phases.read}, {"initial", phases.initial}, {"write", phases.write}};
  json.update(json_of(summary.seconds));
  return json;
}

bool missed_bound(const Result& r) {
  return r.options.max_distortion > 0 && r.result.solution.worst_distortion > r.options.max_distortion;
}

}  // namespace

RunStatus status(const Result& r) {
  if (newton::failed(r.result.solution.summary.status) || !r.result.layout.flipped.empty())
    return RunStatus::failed;
  return r.result.solution.summary.converged() && !missed_bound(r) ? RunStatus::success
                                                                   : RunStatus::not_converged;
}

std::string verdict(const Result& r) {
  const newton::Summary& summary = r.result.solution.summary;
  std::vector<std::string> parts;
  if (!summary.converged()) parts.push_back("not converged: " + summary.message);
  if (missed_bound(r))
    parts.push_back("the largest distortion is " + formatted("%.4g", r.result.solution.worst_distortion) +
                    ", not " + to_text(r.options.max_distortion) + ", after " +
                    std::to_string(r.result.solution.cuts) + " cuts");
  if (!r.result.layout.flipped.empty())
    parts.push_back(std::to_string(r.result.layout.flipped.size()) +
                    " triangle(s) of the result are turned over, the first is " +
                    std::to_string(r.result.layout.flipped[0]));
  if (parts.empty()) return "";
  std::string text;
  for (const std::string& part : parts) text += part + "; ";
  return text + "the best state is written";
}

std::string trace_text(const Result& r) {
  Trace trace = newton::trace_table(r.result.solution.summary);
  trace.add_column("chart", {r.result.solution.chart_of_row.begin(), r.result.solution.chart_of_row.end()});
  return to_csv(trace);
}

Json summary_json(const Result& r, const RunFacts& facts) {
  Json json = json_of(r.result.solution.summary);
  json["soft_pin_energy"] = r.result.solution.soft_pin_energy;
  json["flipped"] = r.result.layout.flipped.size();
  json["initial_flipped"] = r.result.start.flipped;
  json["seconds"] = seconds_json(r.result.solution.summary, facts);
  json["energy_name"] = r.energy.name();
  json["energy_parameters"] = parameters_of(r.energy);
  json["distortion"] = distortion_json(
      parameterization::distortion_statistics(r.result.solution.stretches, r.result.start.rest.weights));
  json["distortion"]["worst"] = r.result.solution.worst_distortion;
  json["mesh"] = mesh_json(r);
  json["repairs"] = repairs_json(r.repairs);
  json["layout"] = layout_json(r);
  json["charts"] = charts_json(r);
  json["options"] = options_json(r);
  json["threads"] = facts.threads;
  json["instruction_set"] = isa_name(active_isa());
  json["version"] = version_string;
  return json;
}

std::string summary_text(const Result& r, const RunFacts& facts) {
  return file_text(summary_json(r, facts));
}

}  // namespace isostretch::reports
