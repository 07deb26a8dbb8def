#include "manipulation_summary.hpp"

#include <isostretch/core/isa.hpp>
#include <isostretch/core/text.hpp>
#include <isostretch/core/version.hpp>
#include <isostretch/deformation/isotropic_stretch.hpp>
#include <isostretch/reports/json_text.hpp>

#include <algorithm>
#include <cmath>
#include <span>

namespace isostretch::comparison {

using deformation::SolidModel;
using deformation::StrainField;

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

Json handles_json(const deformation::HandleSet& handle_set) {
  Json json = Json::array();
  for (const deformation::Handle& handle : handle_set.handles())
    json.push_back(
        {{"name", handle.name}, {"nodes", handle.nodes.size()}, {"kind", handle.soft ? "soft" : "hard"}});
  return json;
}

bool is_solved(const Json& frame) {
  return frame["frame"].get<int>() > 0;
}

template <class Counts>
int count_frames(const ManipulationReport& r, const Counts& counts) {
  return static_cast<int>(std::count_if(r.frames.begin(), r.frames.end(),
                                        [&](const Record& frame) { return counts(json_of(frame)); }));
}

// Of a number in all frames; 0 where a frame has none.
double sum_over(const ManipulationReport& r, const char* key) {
  double total = 0;
  for (const Record& frame : r.frames) total += json_of(frame).value(key, 0.0);
  return total;
}

int count(const ManipulationReport& r, const char* status) {
  return count_frames(r, [&](const Json& f) { return is_solved(f) && f["status"] == status; });
}

int not_reached(const ManipulationReport& r) {
  return count_frames(r, [](const Json& f) { return is_solved(f) && !f["reached"].get<bool>(); });
}

int inverted(const ManipulationReport& r) {
  return count_frames(r, [](const Json& f) { return f.value("inverted", 0) > 0; });
}

int failed(const ManipulationReport& r) {
  int sum = 0;
  for (const char* status : {"failed", "infeasible", "claims_infeasible", "not_applicable", "unavailable",
                             "memory_limit", "crashed", "unreadable"})
    sum += count(r, status);
  return sum;
}

// The first frame of which that is true, in words.
template <class Which, class Words>
void name_first(const ManipulationReport& r, std::vector<std::string>& parts, const Which& which,
                const Words& words) {
  const auto found = std::find_if(r.frames.begin(), r.frames.end(),
                                  [&](const Record& frame) { return which(json_of(frame)); });
  if (found == r.frames.end()) return;
  const Json& frame = json_of(*found);
  parts.push_back(formatted("frame %d ", frame["frame"].get<int>()) + words(frame));
}

}  // namespace

StrainedShape ManipulationReport::shape(const deformation::Strain& strain,
                                        const std::vector<double>& element_rotations,
                                        const Vector& positions) const {
  StrainedShape result{strain.at(positions),
                       deformation::least_eigenvalues(body, element_rotations, positions)};
  result.indefinite = static_cast<int>(std::count_if(result.eigenvalues.begin(), result.eigenvalues.end(),
                                                     [&](double value) { return value < scene.margin; }));
  return result;
}

void ManipulationReport::add(const ManipulationFrame& frame, const StrainedShape& before,
                             const StrainedShape& after, const std::string& file) {
  Json json{{"frame", frame.frame}, {"time", frame.time}};
  if (frame.made()) json["file"] = file;
  json.update(frame.rival ? rival_json(scene.rival, *frame.rival) : solve_json(body, frame.summary));
  json["reached"] = frame.reached();
  if (!frame.rounds.empty()) json["rounds"] = rounds_json(frame.rounds);
  json["seconds"] = frame.seconds;
  if (frame.made()) {
    json["inverted_before"] = before.strain.inverted.size();
    json["not_psd_before"] = before.indefinite;
    json.update(strain_json(after.strain));
    json["not_psd"] = after.indefinite;
    json["min_eigenvalue"] = least(after.eigenvalues);
    json["handles"] = Json::parse(reports::misses_json(misses(frame)));
    json["nearly_flat"] = nearly_flat_json(body, after.strain);
  } else {
    if (!frame.rival) {
      json["status"] = "failed";
      json["message"] = frame.trouble;
    }
    json["reached"] = false;
  }
  frames.push_back(record_of(std::move(json)));
  Trace rows = frame.rival ? baselines::trace_table(*frame.rival) : sdp_penalty::trace_table(frame.summary);
  rows.add_front_column("frame", frame.frame);
  trace.append(rows);
}

void ManipulationReport::add_rest(const StrainField& strain, const std::string& file) {
  Json json{{"frame", 0}, {"time", scene.script.start}, {"file", file}, {"status", "rest"}};
  json.update(strain_json(strain));
  frames.push_back(record_of(std::move(json)));
}

std::string ManipulationReport::frame_text(const ManipulationFrame& frame, const StrainedShape& before,
                                           const StrainedShape& after) const {
  return formatted("frame %d of %d: ", frame.frame, scene.script.frames) +
         (frame.certified() ? "certified"
                            : std::string(frame.status()) + " (" + frame.summary.message + ")") +
         formatted(", %d iterations", frame.summary.iterations) +
         (frame.rival ? std::string() : formatted(", gap %.1e", frame.summary.gap)) +
         formatted(", inverted %zu -> %zu, min det F %.2g, %.2f s", before.strain.inverted.size(),
                   after.strain.inverted.size(), after.strain.smallest_det(), frame.seconds);
}

std::vector<std::string> ManipulationReport::last_warnings(const deformation::Strain& strain) const {
  std::vector<std::string> texts;
  if (last.positions.size() == 0) return texts;
  const std::string frame = formatted("frame %d: ", last.frame);
  for (const std::string& text : deformation::miss_warnings(misses(last), body.diagonal()))
    texts.push_back(frame + text);
  const StrainField field = strain.at(last.positions);
  const std::string flat =
      deformation::nearly_flat_text(deformation::nearly_flat_elements(field), field, body);
  if (!flat.empty()) texts.push_back(frame + flat + "; --margin keeps elements from it");
  return texts;
}

std::vector<deformation::HandleMiss> ManipulationReport::misses(const ManipulationFrame& frame) const {
  return deformation::handle_misses(handle_set, frame.time, body.dim, frame.positions);
}

std::vector<std::pair<std::string, double>> ManipulationReport::files() const {
  std::vector<std::pair<std::string, double>> all;
  for (const Record& frame : frames)
    if (const std::string file = frame.text("file"); !file.empty())
      all.emplace_back(file, frame.number("time"));
  return all;
}

reports::RunStatus ManipulationReport::status() const {
  if (inverted(*this) > 0 || failed(*this) > 0) return reports::RunStatus::failed;
  return !stopped && not_reached(*this) == 0 ? reports::RunStatus::success
                                             : reports::RunStatus::not_converged;
}

std::string ManipulationReport::verdict() const {
  const ManipulationReport& r = *this;
  std::vector<std::string> parts;
  if (r.stopped) parts.push_back(r.message);
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
    const std::string miss = deformation::largest_miss_text(misses(r.last), r.body.diagonal());
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

Json totals_json(const ManipulationReport& r) {
  return {{"iterations", static_cast<long>(sum_over(r, "iterations"))},
          {"linear_solves", static_cast<long>(sum_over(r, "linear_solves"))},
          {"seconds", sum_over(r, "seconds")},
          {"frames_made", count_frames(r, [](const Json& f) { return is_solved(f) && f.contains("file"); })},
          {"frames_wanted", r.wanted},
          {"frames_certified",
           count_frames(r, [](const Json& f) { return is_solved(f) && f["certified"].get<bool>(); })},
          {"frames_with_inverted", inverted(r)},
          {"inverted_before", static_cast<long>(sum_over(r, "inverted_before"))}};
}

}  // namespace

Json summary_json(const ManipulationReport& r, const ManipulationSeconds& seconds, int threads) {
  Json frames = Json::array();
  for (const Record& frame : r.frames) frames.push_back(json_of(frame));
  return {
      {"outcome", r.stopped ? "stopped" : "finished"},
      {"certified", r.scene.rival.empty() && !r.stopped && not_reached(r) == 0},
      {"message", r.verdict()},
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
      {"frames", frames},
      {"scene", Json::parse(scene::to_json(r.scene.value))},
      {"threads", threads},
      {"instruction_set", isa_name(active_isa())},
      {"version", version_string}};
}

std::string summary_text(const ManipulationReport& report, const ManipulationSeconds& seconds, int threads) {
  return file_text(summary_json(report, seconds, threads));
}

}  // namespace isostretch::comparison
