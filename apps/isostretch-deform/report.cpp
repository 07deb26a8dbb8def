#include "report.hpp"
#include "common/handle_miss_report.hpp"

#include "common/newton_report.hpp"
#include "common/scene_input.hpp"
#include "common/sequence_report.hpp"
#include "common/threads.hpp"

#include <isostretch/core/isa.hpp>
#include <isostretch/core/text.hpp>
#include <isostretch/core/version.hpp>
#include <isostretch/deformation/handle_misses.hpp>

#include <algorithm>
#include <numeric>

namespace isostretch::app::deform {
namespace {

Json strain_json(const StrainField& strain) {
  return {{"min_det_F", strain.smallest_det()},
          {"min_det_F_element", strain.worst_element()},
          {"max_length_change", *std::max_element(strain.length_change.begin(), strain.length_change.end())},
          {"inverted", strain.inverted.size()}};
}

const char* outcome_name(Outcome outcome) {
  switch (outcome) {
    case Outcome::finished:
      return "finished";
    case Outcome::stop_after:
      return "stopped_by_stop_after";
    case Outcome::stopped:
      return "stopped";
    case Outcome::failed:
      break;
  }
  return "failed";
}

Json mesh_json(const SolidModel& body) {
  return {{"name", body.name},
          {"element", mesh::shape_name(body.shape)},
          {"nodes", body.nodes.rows()},
          {"elements", body.elements.element_count()},
          {"points_per_element", body.elements.points_per_element},
          {body.dim == 2 ? "area" : "volume", body.volume()},
          {"diagonal", body.diagonal()},
          {"fingerprint", body.fingerprint()}};
}

Json handles_json(const HandleSet& handle_set) {
  Json json = Json::array();
  for (const Handle& handle : handle_set.handles()) {
    Json entry{
        {"name", handle.name}, {"nodes", handle.nodes.size()}, {"kind", handle.soft ? "soft" : "hard"}};
    if (handle.soft) entry["weight"] = *handle.soft;
    json.push_back(std::move(entry));
  }
  return json;
}

Json regions_json(const deformation::ElasticProblem& problem) {
  Json json = Json::array();
  for (const deformation::Region& region : problem.regions()) {
    Json parameters = Json::object();
    for (const auto& parameter : region.energy.parameters()) parameters[parameter.name] = parameter.value;
    json.push_back({{"name", region.name},
                    {"elements", region.elements.size()},
                    {"energy_name", region.energy.name()},
                    {"energy_parameters", parameters}});
  }
  return json;
}

// Frame 0 is none of those wanted.
int reached_frames(const Json& frames) {
  return count_frames(frames, [](const Json& frame) { return frame["reached"].get<bool>(); }) - 1;
}

}  // namespace

Json frame_json(int frame, const deformation::FrameResult& result, double time, const StrainField& strain,
                const Json& handles, const std::string& file) {
  const newton::Summary& s = result.summary;
  Json json{{"frame", frame},
            {"time", time},
            {"file", file},
            {"reached", result.reached},
            {"status", newton::status_name(s.status)},
            {"converged", result.reached && s.converged()},
            {"message", result.why.empty() ? s.message : result.why},
            {"parts", result.parts},
            {"iterations", s.iterations},
            {"factorizations", s.factorizations},
            {"failed_factorizations", s.failed_factorizations},
            {"energy_evaluations", s.energy_evaluations},
            {"energy", s.energy},
            {"gradient_inf_norm", s.gradient_inf_norm},
            {"seconds", result.seconds},
            {"handles", handles}};
  json.update(strain_json(strain));
  return json;
}

Json rest_frame_json(const Result& result, const StrainField& strain, const std::string& file) {
  Json json{{"frame", 0},          {"time", result.scene.script.start},
            {"file", file},        {"reached", true},
            {"status", "rest"},    {"converged", true},
            {"parts", 0},          {"iterations", 0},
            {"factorizations", 0}, {"handles", Json::array()}};
  json.update(strain_json(strain));
  return json;
}

std::string trace_rows(int frame, const newton::Summary& summary, bool head) {
  Trace trace = newton::trace_table(summary);
  trace.add_column("frame", std::vector<double>(trace.rows.size(), frame));
  const std::string text = to_csv(trace);
  return head ? text : text.substr(text.find('\n') + 1);
}

int inverted_frames(const Result& r) {
  return count_frames(r.frames, [](const Json& frame) { return frame["inverted"].get<int>() > 0; });
}

int unconverged_frames(const Result& r) {
  return count_frames(r.frames, [](const Json& frame) { return !frame["converged"].get<bool>(); });
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
  for (const Json& frame : r.frames) {
    if (frame["inverted"].get<int>() == 0) continue;
    parts.push_back(formatted("frame %d has %d inverted element(s), the worst is ", frame["frame"].get<int>(),
                              frame["inverted"].get<int>()) +
                    r.body.element_text(frame["min_det_F_element"].get<int>()));
    break;
  }
  if (parts.empty()) return "all frames converged, no element is inverted";
  std::string text;
  for (const std::string& part : parts) text.append(text.empty() ? "" : "; ").append(part);
  if (r.outcome != Outcome::finished && r.outcome != Outcome::failed) text += "; --restart goes on";
  return text;
}

Json summary_json(const Result& r, const PhaseSeconds& seconds) {
  const Json& last = r.frames.back();
  Json json{{"outcome", outcome_name(r.outcome)},
            {"converged", r.outcome == Outcome::finished && unconverged_frames(r) == 0},
            {"message", verdict(r)},
            {"frames_made", reached_frames(r.frames)},
            {"frames_wanted", r.scene.script.frames},
            {"restarted_at", r.restarted_at},
            {"iterations", static_cast<long>(sum_over(r.frames, "iterations"))},
            {"factorizations", static_cast<long>(sum_over(r.frames, "factorizations"))},
            {"frame_seconds", sum_over(r.frames, "seconds")},
            {"min_det_F", last["min_det_F"]},
            {"inverted", last["inverted"]},
            {"frames_with_inverted", inverted_frames(r)},
            {"seconds",
             {{"total", seconds.total},
              {"read", seconds.read},
              {"solve", seconds.solve},
              {"write", seconds.write}}},
            {"mesh", mesh_json(r.body)},
            {"handles", handles_json(r.handle_set)},
            {"regions", regions_json(r.problem)},
            {"warnings", r.warnings},
            {"frames", r.frames},
            {"scene", report_json(r.scene.value)},
            {"threads", thread_count()},
            {"instruction_set", isa_name(active_isa())},
            {"version", version_string}};
  return json;
}

}  // namespace isostretch::app::deform
