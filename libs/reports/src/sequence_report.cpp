#include "sequence_record.hpp"

#include "handle_misses.hpp"

#include <isostretch/core/isa.hpp>
#include <isostretch/core/text.hpp>
#include <isostretch/core/version.hpp>

#include <algorithm>
#include <utility>

namespace isostretch::reports {
namespace {

using deformation::Handle;
using deformation::HandleSet;
using deformation::SolidModel;
using deformation::StrainField;

Json strain_json(const StrainField& strain) {
  return {{"min_det_F", strain.smallest_det()},
          {"min_det_F_element", strain.worst_element()},
          {"max_length_change", *std::max_element(strain.length_change.begin(), strain.length_change.end())},
          {"inverted", strain.inverted.size()}};
}

const char* end_name(SequenceEnd end) {
  switch (end) {
    case SequenceEnd::finished:
      return "finished";
    case SequenceEnd::stop_after:
      return "stopped_by_stop_after";
    case SequenceEnd::stopped:
      return "stopped";
    case SequenceEnd::failed:
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
    json.push_back({{"name", region.name},
                    {"elements", region.elements.size()},
                    {"energy_name", region.energy.name()},
                    {"energy_parameters", parameters_of(region.energy)}});
  }
  return json;
}

// Frame 0 is none of those wanted.
int reached_frames(const Json& frames) {
  return count_frames(frames, [](const Json& frame) { return frame["reached"].get<bool>(); }) - 1;
}

Json frame_json(int frame, const deformation::FrameResult& result, const StrainField& strain,
                const Json& handles, const std::string& file) {
  const newton::Summary& s = result.summary;
  Json json{{"frame", frame},
            {"time", result.time},
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

Json rest_frame_json(double time, const StrainField& strain, const std::string& file) {
  Json json{{"frame", 0},          {"time", time},
            {"file", file},        {"reached", true},
            {"status", "rest"},    {"converged", true},
            {"parts", 0},          {"iterations", 0},
            {"factorizations", 0}, {"handles", Json::array()}};
  json.update(strain_json(strain));
  return json;
}

}  // namespace

SequenceReport::SequenceReport(const SequenceInput& input) : record_(new Record{.input = input}) {}
SequenceReport::~SequenceReport() = default;
SequenceReport::SequenceReport(SequenceReport&&) noexcept = default;

void SequenceReport::add_rest(const StrainField& strain, const std::string& file) {
  record_->frames.push_back(rest_frame_json(record_->input.script.start, strain, file));
}

void SequenceReport::add_frame(int frame, const deformation::FrameResult& result, const StrainField& strain,
                               const std::vector<deformation::HandleMiss>& misses, const std::string& file) {
  record_->frames.push_back(frame_json(frame, result, strain, json_of(misses), file));
  record_->trace += trace_rows(result.summary, frame, record_->trace.empty());
}

void SequenceReport::end(SequenceEnd end, std::string message) {
  record_->end = end;
  record_->message = std::move(message);
}

void SequenceReport::add_warning(std::string text) {
  record_->warnings.push_back(std::move(text));
}

RunStatus SequenceReport::status() const {
  const Json& frames = record_->frames;
  if (record_->end == SequenceEnd::failed || inverted_frames(frames) > 0) return RunStatus::failed;
  return record_->end == SequenceEnd::finished && unconverged_frames(frames) == 0 ? RunStatus::success
                                                                                  : RunStatus::not_converged;
}

std::string SequenceReport::verdict() const {
  const Record& r = *record_;
  const bool finished = r.end == SequenceEnd::finished;
  std::vector<std::string> parts;
  if (!finished) parts.push_back(r.message);
  if (finished && unconverged_frames(r.frames) > 0)
    parts.push_back(formatted("%d frame(s) did not converge", unconverged_frames(r.frames)));
  for (const Json& frame : r.frames) {
    if (frame["inverted"].get<int>() == 0) continue;
    parts.push_back(formatted("frame %d has %d inverted element(s), the worst is ", frame["frame"].get<int>(),
                              frame["inverted"].get<int>()) +
                    r.input.body.element_text(frame["min_det_F_element"].get<int>()));
    break;
  }
  if (parts.empty()) return "all frames converged, no element is inverted";
  std::string text;
  for (const std::string& part : parts) text.append(text.empty() ? "" : "; ").append(part);
  if (!finished && r.end != SequenceEnd::failed) text += "; --restart goes on";
  return text;
}

const std::string& SequenceReport::trace_text() const {
  return record_->trace;
}

std::string SequenceReport::animation_text() const {
  return reports::animation_text(record_->frames);
}

figures::SequenceFigure SequenceReport::figure(const Vector& positions) const {
  const auto& [scene, script, body, handle_set, problem] = record_->input;
  const Json& last = record_->frames.back();
  long iterations = 0;
  for (const Json& frame : record_->frames) iterations += frame.value("iterations", 0);
  return {body,          handle_set, problem, positions, last["frame"].get<int>(), last["time"].get<double>(),
          script.frames, iterations};
}

Json SequenceReport::Record::summary(const std::string& verdict, const RunFacts& facts) const {
  const Json& last = frames.back();
  return {{"outcome", end_name(end)},
          {"converged", end == SequenceEnd::finished && unconverged_frames(frames) == 0},
          {"message", verdict},
          {"frames_made", reached_frames(frames)},
          {"frames_wanted", input.script.frames},
          {"restarted_at", restarted_at},
          {"iterations", static_cast<long>(sum_over(frames, "iterations"))},
          {"factorizations", static_cast<long>(sum_over(frames, "factorizations"))},
          {"frame_seconds", sum_over(frames, "seconds")},
          {"min_det_F", last["min_det_F"]},
          {"inverted", last["inverted"]},
          {"frames_with_inverted", inverted_frames(frames)},
          {"seconds",
           {{"total", facts.total}, {"read", facts.read}, {"solve", facts.solve}, {"write", facts.write}}},
          {"mesh", mesh_json(input.body)},
          {"handles", handles_json(input.handle_set)},
          {"regions", regions_json(input.problem)},
          {"warnings", warnings},
          {"frames", frames},
          {"scene", json_of(input.scene)},
          {"threads", facts.threads},
          {"instruction_set", isa_name(active_isa())},
          {"version", version_string}};
}

}  // namespace isostretch::reports
