#include "report.hpp"

#include "common/newton_report.hpp"
#include "common/scene_input.hpp"
#include "common/sequence_report.hpp"
#include "common/threads.hpp"

#include <isostretch/core/isa.hpp>
#include <isostretch/core/text.hpp>
#include <isostretch/core/version.hpp>

#include <algorithm>

namespace isostretch::app::interpolate {
namespace {

const char* outcome_name(Outcome outcome) {
  return outcome == Outcome::finished ? "finished" : outcome == Outcome::stopped ? "stopped" : "failed";
}

void add_strain(Json& json, const Strains& strains) {
  for (std::size_t i = 0; i < 2; ++i) {
    const std::string pose = i == 0 ? "_1" : "_2";
    const StrainField& strain = strains[i];
    json["min_det_F" + pose] = strain.smallest_det();
    json["min_det_F_element" + pose] = strain.worst_element();
    json["max_length_change" + pose] =
        *std::max_element(strain.length_change.begin(), strain.length_change.end());
  }
  // The same for both: neither pose has inverted elements.
  json["inverted"] = strains[0].inverted.size();
}

Json frame_json(const deformation::InterpolationFrame& frame, const Strains& strains,
                const std::string& file) {
  const newton::Summary& s = frame.summary;
  Json json{{"frame", frame.number}, {"time", frame.time}, {"file", file}};
  json["status"] = frame.solved ? std::string(newton::status_name(s.status)) : std::string("pose");
  json["converged"] = !frame.solved || s.converged();
  json["psi_1"] = frame.psi[0];
  json["psi_2"] = frame.psi[1];
  json["energy"] = (1 - frame.time) * frame.psi[0] + frame.time * frame.psi[1];
  json["change"] = frame.change;
  json["iterations"] = frame.solved ? s.iterations : 0;
  json["factorizations"] = frame.solved ? s.factorizations : 0;
  if (frame.solved) {
    json["start"] = frame.start;
    json["message"] = s.message;
    json["failed_factorizations"] = s.failed_factorizations;
    json["energy_evaluations"] = s.energy_evaluations;
    json["gradient_inf_norm"] = s.gradient_inf_norm;
    json["seconds"] = frame.seconds;
  }
  add_strain(json, strains);
  return json;
}

std::string trace_rows(const deformation::InterpolationFrame& frame, bool head) {
  const newton::Summary& s = frame.summary;
  Trace trace = newton::trace_table(s);
  trace.add_column("frame", std::vector<double>(trace.rows.size(), frame.number));
  const std::string text = to_csv(trace);
  return head ? text : text.substr(text.find('\n') + 1);
}

void add_to(newton::Seconds& sum, const newton::Seconds& s) {
  sum.total += s.total, sum.setup += s.setup, sum.assembly += s.assembly;
  sum.factorization += s.factorization, sum.solve += s.solve, sum.line_search += s.line_search;
}

int inverted_frames(const Result& r) {
  return count_frames(r.frames, [](const Json& frame) { return frame["inverted"].get<int>() > 0; });
}

int unconverged_frames(const Result& r) {
  return count_frames(r.frames, [](const Json& frame) { return !frame["converged"].get<bool>(); });
}

// Over all frames and both poses.
double smallest_det(const Result& r) {
  double least = HUGE_VAL;
  for (const Json& frame : r.frames)
    least = std::min({least, frame["min_det_F_1"].get<double>(), frame["min_det_F_2"].get<double>()});
  return least;
}

std::string inverted_text(const Result& r) {
  for (const Json& frame : r.frames)
    if (frame["inverted"].get<int>() > 0)
      return formatted("frame %d has %d inverted element(s), the worst is ", frame["frame"].get<int>(),
                       frame["inverted"].get<int>()) +
             r.poses.first.element_text(frame["min_det_F_element_1"].get<int>());
  return {};
}

Json mesh_json(const deformation::KeyShapes& poses) {
  const SolidModel &a = poses.first, &b = poses.second;
  const char* size = a.dim == 2 ? "area" : "volume";
  return {{"element", mesh::shape_name(a.shape)},
          {"nodes", a.nodes.rows()},
          {"elements", a.elements.element_count()},
          {"first", {{"name", a.name}, {size, a.volume()}, {"diagonal", a.diagonal()}}},
          {"second", {{"name", b.name}, {size, b.volume()}, {"diagonal", b.diagonal()}}}};
}

Json parameters_json(const energies::AnyEnergy& energy) {
  Json parameters = Json::object();
  for (const auto& parameter : energy.parameters()) parameters[parameter.name] = parameter.value;
  return parameters;
}

}  // namespace

void add_frame(Result& r, const deformation::InterpolationFrame& frame, const Strains& strains,
               const std::string& file) {
  r.frames.push_back(frame_json(frame, strains, file));
  r.trace += trace_rows(frame, r.trace.empty());
  add_to(r.phases, frame.summary.seconds);
  if (!frame.summary.solver.empty()) r.solver = frame.summary.solver;
}

bool jumps_at_the_end(const Result& r) {
  constexpr double times = 4, visible = 0.01;
  if (r.outcome != Outcome::finished || r.frames.size() < 4) return false;
  double most = 0;
  for (std::size_t i = 1; i + 1 < r.frames.size(); ++i)
    most = std::max(most, r.frames[i]["change"].get<double>());
  const double last = r.frames.back()["change"];
  return last > visible && last > times * most;
}

ExitCode exit_code(const Result& r) {
  if (r.outcome == Outcome::failed || inverted_frames(r) > 0) return ExitCode::solver_failed;
  return r.outcome == Outcome::finished && unconverged_frames(r) == 0 ? ExitCode::success
                                                                      : ExitCode::not_converged;
}

std::string verdict(const Result& r) {
  std::vector<std::string> parts;
  if (r.outcome != Outcome::finished) parts.push_back(r.message);
  if (r.outcome == Outcome::finished && unconverged_frames(r) > 0)
    parts.push_back(formatted("%d frame(s) did not converge", unconverged_frames(r)));
  if (inverted_frames(r) > 0) parts.push_back(inverted_text(r));
  if (parts.empty()) return "all frames converged, no element is inverted";
  return parts.size() == 1 ? parts[0] : parts[0] + "; " + parts[1];
}

Json summary_json(const Result& r, const PhaseSeconds& seconds) {
  Json json{{"outcome", outcome_name(r.outcome)},
            {"converged", r.outcome == Outcome::finished && unconverged_frames(r) == 0},
            {"message", verdict(r)},
            {"frames_made", r.frames.size() - 1},
            {"frames_wanted", r.options.frames},
            {"iterations", static_cast<long>(sum_over(r.frames, "iterations"))},
            {"factorizations", static_cast<long>(sum_over(r.frames, "factorizations"))},
            {"frame_seconds", sum_over(r.frames, "seconds")},
            {"phases", phases_json(r.phases)},
            {"min_det_F", smallest_det(r)},
            {"frames_with_inverted", inverted_frames(r)},
            {"energy_name", r.energy.name()},
            {"energy_parameters", parameters_json(r.energy)},
            {"initial_guess", name_of(choice_names(r.options.guess), r.options.guess)},
            {"scene", report_json(r.options.value)},
            {"projection", newton::projection_name(r.options.newton.projection)},
            {"solver", r.solver},
            {"mesh", mesh_json(r.poses)},
            {"warnings", r.warnings},
            {"frames", r.frames}};
  json["seconds"] = {
      {"total", seconds.total}, {"read", seconds.read}, {"solve", seconds.solve}, {"write", seconds.write}};
  json["threads"] = thread_count();
  json["instruction_set"] = isa_name(active_isa());
  json["version"] = version_string;
  return json;
}

}  // namespace isostretch::app::interpolate
