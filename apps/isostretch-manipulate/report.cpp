#include "report.hpp"
#include "common/handle_miss_report.hpp"

#include "common/scene_input.hpp"
#include "common/sequence_report.hpp"
#include "common/threads.hpp"

#include <isostretch/core/isa.hpp>
#include <isostretch/core/text.hpp>
#include <isostretch/core/to_text.hpp>
#include <isostretch/core/version.hpp>
#include <isostretch/deformation/handle_misses.hpp>
#include <isostretch/deformation/isotropic_stretch.hpp>

#include <algorithm>
#include <cmath>
#include <span>

namespace isostretch::app::manipulate {
namespace {

Json rival_json(const std::string& name, const baselines::Result& r) {
  return {{"status", baselines::status_name(r.status)},
          {"certified", false},
          {"message", r.message},
          {"solver", name},
          {"iterations", r.iterations},
          {"linear_solves", r.linear_solves},
          {"energy", r.measures.energy},
          {"elastic_energy", r.measures.energy - r.measures.target_energy},
          {"target_energy", r.measures.target_energy},
          {"distortion", r.measures.distortion},
          {"lower_bound", r.lower_bound},
          {"peak_megabytes", r.peak_megabytes},
          {"solver_seconds",
           {{"modelling", r.seconds.modelling},
            {"solving", r.seconds.solving},
            {"reading", r.seconds.reading},
            {"total", r.seconds.total()}}},
          {"infeasible_elements", Json::array()}};
}

Json solve_json(const SolidModel& body, const sdp_penalty::Summary& s) {
  Json infeasible_elements = Json::array();
  for (const int element : s.infeasible_elements) infeasible_elements.push_back(body.element_text(element));
  Json json{{"status", sdp_penalty::status_name(s.status)},
            {"certified", s.status == sdp_penalty::Status::optimal},
            {"message", s.message},
            {"iterations", s.iterations},
            {"linear_solves", s.linear_solves},
            {"energy", s.energy},
            {"elastic_energy", s.energy - s.target_energy},
            {"target_energy", s.target_energy},
            {"lower_bound", s.lower_bound},
            {"gap", s.gap},
            {"infeasible_elements", infeasible_elements}};
  if (s.status == sdp_penalty::Status::infeasible) {
    json["unreachable_eigenvalue"] = s.unreachable_eigenvalue;
    json["extent"] = s.extent;
  }
  return json;
}

Json rounds_json(const std::vector<sdp_penalty::RelinearizeRound>& rounds) {
  Json json = Json::array();
  for (const sdp_penalty::RelinearizeRound& round : rounds)
    json.push_back({{"energy", round.energy},
                    {"inverted", round.inverted},
                    {"penalty_solution", round.penalty_solution},
                    {"linear_solves", round.linear_solves},
                    {"seconds", round.seconds}});
  return json;
}

Json strain_json(const StrainField& strain) {
  return {{"inverted", strain.inverted.size()},
          {"min_det_F", strain.smallest_det()},
          {"min_det_F_element", strain.worst_element()},
          {"max_length_change", *std::max_element(strain.length_change.begin(), strain.length_change.end())}};
}

// Ten of them at most are named; all are counted.
Json nearly_flat_json(const SolidModel& body, const StrainField& strain) {
  const std::vector<int> elements = deformation::nearly_flat_elements(strain);
  Json named = Json::array();
  for (const int element : std::span(elements).first(std::min<std::size_t>(elements.size(), 10)))
    named.push_back(body.element_text(element));
  return {{"count", elements.size()}, {"flattest", named}};
}

double least(const std::vector<double>& values) {
  return *std::min_element(values.begin(), values.end());
}

Json mesh_json(const SolidModel& body) {
  return {{"name", body.name},
          {"element", mesh::shape_name(body.shape)},
          {"nodes", body.nodes.rows()},
          {"elements", body.elements.element_count()},
          {body.dim == 2 ? "area" : "volume", body.volume()},
          {"diagonal", body.diagonal()},
          {"fingerprint", body.fingerprint()}};
}

Json handles_json(const HandleSet& handle_set) {
  Json json = Json::array();
  for (const Handle& handle : handle_set.handles())
    json.push_back(
        {{"name", handle.name}, {"nodes", handle.nodes.size()}, {"kind", handle.soft ? "soft" : "hard"}});
  return json;
}

bool is_solved(const Json& frame) {
  return frame["frame"].get<int>() > 0;
}

int count(const Json& frames, const char* status) {
  return count_frames(frames, [&](const Json& f) { return is_solved(f) && f["status"] == status; });
}

int not_reached(const Result& r) {
  return count_frames(r.frames, [](const Json& f) { return is_solved(f) && !f["reached"].get<bool>(); });
}

int inverted(const Result& r) {
  return count_frames(r.frames, [](const Json& f) { return f.value("inverted", 0) > 0; });
}

int failed(const Result& r) {
  int sum = 0;
  for (const char* status : {"failed", "infeasible", "claims_infeasible", "not_applicable", "unavailable",
                             "memory_limit", "crashed", "unreadable"})
    sum += count(r.frames, status);
  return sum;
}

// The first frame of which that is true, in words.
template <class Which, class Words>
void name_first(const Result& r, std::vector<std::string>& parts, const Which& which, const Words& words) {
  const Json::const_iterator found = std::find_if(r.frames.begin(), r.frames.end(), which);
  if (found != r.frames.end())
    parts.push_back(formatted("frame %d ", (*found)["frame"].get<int>()) + words(*found));
}

}  // namespace

Shape shape_of(const Result& result, const Strain& strain, const std::vector<double>& rotations,
               const Vector& positions) {
  Shape shape{strain.at(positions), least_eigenvalues(result.body, rotations, positions)};
  shape.indefinite =
      static_cast<int>(std::count_if(shape.eigenvalues.begin(), shape.eigenvalues.end(),
                                     [&](double value) { return value < result.scene.margin; }));
  return shape;
}

void add_frame(Result& result, const FrameResult& frame, const Shape& before, const Shape& after,
               const std::string& file) {
  Json json{{"frame", frame.frame}, {"time", frame.time}};
  if (frame.made()) json["file"] = file;
  json.update(frame.rival ? rival_json(result.scene.rival, *frame.rival)
                          : solve_json(result.body, frame.summary));
  json["reached"] = frame.reached();
  if (!frame.rounds.empty()) json["rounds"] = rounds_json(frame.rounds);
  json["seconds"] = frame.seconds;
  if (frame.made()) {
    json["inverted_before"] = before.strain.inverted.size();
    json["not_psd_before"] = before.indefinite;
    json.update(strain_json(after.strain));
    json["not_psd"] = after.indefinite;
    json["min_eigenvalue"] = least(after.eigenvalues);
    json["handles"] = misses_json(
        deformation::handle_misses(result.handle_set, frame.time, result.body.dim, frame.positions));
    json["nearly_flat"] = nearly_flat_json(result.body, after.strain);
  } else {
    if (!frame.rival) {
      json["status"] = "failed";
      json["message"] = frame.trouble;
    }
    json["reached"] = false;
  }
  result.frames.push_back(std::move(json));
  Trace trace = frame.rival ? baselines::trace_table(*frame.rival) : sdp_penalty::trace_table(frame.summary);
  trace.add_front_column("frame", frame.frame);
  result.trace.append(trace);
}

void add_rest_frame(Result& result, const StrainField& strain, const std::string& file) {
  Json json{{"frame", 0}, {"time", result.scene.script.start}, {"file", file}, {"status", "rest"}};
  json.update(strain_json(strain));
  result.frames.push_back(std::move(json));
}

ExitCode exit_code(const Result& r) {
  if (inverted(r) > 0 || failed(r) > 0) return ExitCode::solver_failed;
  return r.outcome == Outcome::finished && not_reached(r) == 0 ? ExitCode::success : ExitCode::not_converged;
}

std::string verdict(const Result& r) {
  std::vector<std::string> parts;
  if (r.outcome == Outcome::stopped) parts.push_back(r.message);
  name_first(
      r, parts,
      [](const Json& f) { return is_solved(f) && !f["reached"].get<bool>() && f["status"] != "callback"; },
      [&](const Json& f) {
        std::string text = f["status"].get<std::string>() + ": " + f["message"].get<std::string>();
        if (!f["infeasible_elements"].empty())
          text += "; look at " + f["infeasible_elements"][0].get<std::string>();
        return (r.scene.rival.empty() ? "is not certified (" : "is not solved (") + text + ")";
      });
  name_first(
      r, parts, [](const Json& f) { return f.value("inverted", 0) > 0; },
      [&](const Json& f) {
        return formatted("has %d inverted element(s), the worst is ", f["inverted"].get<int>()) +
               r.body.element_text(f["min_det_F_element"].get<int>());
      });
  if (parts.empty()) {
    const std::string good = r.scene.rival.empty()
                                 ? "all frames are certified, no element is inverted"
                                 : "all frames are solved by " + r.scene.rival + ", no element is inverted";
    if (r.last.positions.size() == 0) return good;
    const std::string miss = deformation::largest_miss_text(
        deformation::handle_misses(r.handle_set, r.last.time, r.body.dim, r.last.positions),
        r.body.diagonal());
    return miss.empty() ? good : good + "; " + miss;
  }
  std::string text;
  for (const std::string& part : parts) text.append(text.empty() ? "" : "; ").append(part);
  return text;
}

namespace {

Json weights_json(const deformation::ElementRotations& rotations, double seconds) {
  if (!rotations.weights()) return nullptr;
  Json handles = Json::array();
  for (const handles::WeightReport& report : rotations.weights()->reports)
    handles.push_back({{"iterations", report.iterations},
                       {"factorizations", report.factorizations},
                       {"kkt_residual", report.kkt_residual}});
  return {{"from_cache", rotations.from_cache()}, {"seconds", seconds}, {"handles", handles}};
}

Json totals_json(const Result& r) {
  return {{"iterations", static_cast<long>(sum_over(r.frames, "iterations"))},
          {"linear_solves", static_cast<long>(sum_over(r.frames, "linear_solves"))},
          {"seconds", sum_over(r.frames, "seconds")},
          {"frames_made",
           count_frames(r.frames, [](const Json& f) { return is_solved(f) && f.contains("file"); })},
          {"frames_wanted", r.wanted},
          {"frames_certified",
           count_frames(r.frames, [](const Json& f) { return is_solved(f) && f["certified"].get<bool>(); })},
          {"frames_with_inverted", inverted(r)},
          {"inverted_before", static_cast<long>(sum_over(r.frames, "inverted_before"))}};
}

}  // namespace

Json summary_json(const Result& r, const PhaseSeconds& seconds) {
  return {
      {"outcome", r.outcome == Outcome::finished ? "finished" : "stopped"},
      {"certified", r.scene.rival.empty() && r.outcome == Outcome::finished && not_reached(r) == 0},
      {"message", verdict(r)},
      {"totals", totals_json(r)},
      {"seconds",
       {{"total", seconds.total},
        {"read", seconds.read},
        {"weights", seconds.weights},
        {"solve", seconds.solve},
        {"write", seconds.write}}},
      {"mesh", mesh_json(r.body)},
      {"handles", handles_json(r.handle_set)},
      {"handle_weights", weights_json(r.rotations, seconds.weights)},
      {"blend", r.rotations.weights() ? Json(name_of(choice_names(r.scene.blend), r.scene.blend)) : Json()},
      {"method",
       r.scene.rival.empty() ? std::string(sdp_penalty::method_name(r.scene.solver.method)) : r.scene.rival},
      {"warnings", r.warnings},
      {"frames", r.frames},
      {"scene", report_json(r.scene.value)},
      {"threads", thread_count()},
      {"instruction_set", isa_name(active_isa())},
      {"version", version_string}};
}

}  // namespace isostretch::app::manipulate
