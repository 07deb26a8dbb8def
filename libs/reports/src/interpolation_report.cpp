#include "interpolation_record.hpp"

#include <isostretch/core/isa.hpp>
#include <isostretch/core/text.hpp>
#include <isostretch/core/version.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace isostretch::reports {
namespace {

using deformation::SolidModel;
using deformation::StrainField;
using Strains = std::array<StrainField, 2>;

const char* end_name(InterpolationEnd end) {
  using enum InterpolationEnd;
  return end == finished ? "finished" : end == stopped ? "stopped" : "failed";
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

void add_to(newton::Seconds& sum, const newton::Seconds& s) {
  sum.total += s.total, sum.setup += s.setup, sum.assembly += s.assembly;
  sum.factorization += s.factorization, sum.solve += s.solve, sum.line_search += s.line_search;
}

// Over all frames and both poses.
double smallest_det(const Json& frames) {
  double least = HUGE_VAL;
  for (const Json& frame : frames)
    least = std::min({least, frame["min_det_F_1"].get<double>(), frame["min_det_F_2"].get<double>()});
  return least;
}

std::string inverted_text(const Json& frames, const SolidModel& body) {
  for (const Json& frame : frames)
    if (frame["inverted"].get<int>() > 0)
      return formatted("frame %d has %d inverted element(s), the worst is ", frame["frame"].get<int>(),
                       frame["inverted"].get<int>()) +
             body.element_text(frame["min_det_F_element_1"].get<int>());
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

}  // namespace

InterpolationReport::InterpolationReport(const InterpolationInput& input)
    : record_(new Record{.input = input}) {}
InterpolationReport::~InterpolationReport() = default;
InterpolationReport::InterpolationReport(InterpolationReport&&) noexcept = default;

void InterpolationReport::add_frame(const deformation::InterpolationFrame& frame, const Strains& strains,
                                    const std::string& file) {
  Record& r = *record_;
  r.frames.push_back(frame_json(frame, strains, file));
  r.trace += trace_rows(frame.summary, frame.number, r.trace.empty());
  add_to(r.phases, frame.summary.seconds);
  if (!frame.summary.solver.empty()) r.solver = frame.summary.solver;
}

void InterpolationReport::add_snapshot(figures::Snapshot shot) {
  figures::keep_snapshot(record_->snapshots, std::move(shot), record_->input.options.frames);
}

void InterpolationReport::end(InterpolationEnd end, std::string message) {
  record_->end = end;
  record_->message = std::move(message);
}

void InterpolationReport::add_warning(std::string text) {
  record_->warnings.push_back(std::move(text));
}

bool InterpolationReport::jumps_at_the_end() const {
  constexpr double times = 4, visible = 0.01;
  const Json& frames = record_->frames;
  if (record_->end != InterpolationEnd::finished || frames.size() < 4) return false;
  double most = 0;
  for (std::size_t i = 1; i + 1 < frames.size(); ++i)
    most = std::max(most, frames[i]["change"].get<double>());
  const double last = frames.back()["change"];
  return last > visible && last > times * most;
}

RunStatus InterpolationReport::status() const {
  const Record& r = *record_;
  if (r.end == InterpolationEnd::failed || inverted_frames(r.frames) > 0) return RunStatus::failed;
  return r.end == InterpolationEnd::finished && unconverged_frames(r.frames) == 0 ? RunStatus::success
                                                                                  : RunStatus::not_converged;
}

std::string InterpolationReport::verdict() const {
  const Record& r = *record_;
  const bool finished = r.end == InterpolationEnd::finished;
  std::vector<std::string> parts;
  if (!finished) parts.push_back(r.message);
  if (finished && unconverged_frames(r.frames) > 0)
    parts.push_back(formatted("%d frame(s) did not converge", unconverged_frames(r.frames)));
  if (inverted_frames(r.frames) > 0) parts.push_back(inverted_text(r.frames, r.input.key_shapes.first));
  if (parts.empty()) return "all frames converged, no element is inverted";
  return parts.size() == 1 ? parts[0] : parts[0] + "; " + parts[1];
}

const std::string& InterpolationReport::trace_text() const {
  return record_->trace;
}

std::string InterpolationReport::animation_text() const {
  return reports::animation_text(record_->frames);
}

figures::InterpolationFigure InterpolationReport::figure() const {
  const Record& r = *record_;
  figures::InterpolationFigure figure{.key_shapes = r.input.key_shapes,
                                      .energy_name = r.input.energy.name(),
                                      .frames = r.input.options.frames,
                                      .iterations = 0,
                                      .snapshots = r.snapshots,
                                      .points = {}};
  for (const Json& frame : r.frames) {
    figure.iterations += frame["iterations"].get<long>();
    const auto number = [&](const char* key) { return frame[key].get<double>(); };
    figure.points.push_back({number("time"), number("psi_1"), number("psi_2"), number("energy"),
                             number("min_det_F_1"), number("min_det_F_2")});
  }
  return figure;
}

Json InterpolationReport::Record::summary(const std::string& verdict, const RunFacts& facts) const {
  const deformation::InterpolationOptions& options = input.options;
  return {{"outcome", end_name(end)},
          {"converged", end == InterpolationEnd::finished && unconverged_frames(frames) == 0},
          {"message", verdict},
          {"frames_made", frames.size() - 1},
          {"frames_wanted", options.frames},
          {"iterations", static_cast<long>(sum_over(frames, "iterations"))},
          {"factorizations", static_cast<long>(sum_over(frames, "factorizations"))},
          {"frame_seconds", sum_over(frames, "seconds")},
          {"phases", json_of(phases)},
          {"min_det_F", smallest_det(frames)},
          {"frames_with_inverted", inverted_frames(frames)},
          {"energy_name", input.energy.name()},
          {"energy_parameters", parameters_of(input.energy)},
          {"initial_guess", name_of(choice_names(options.guess), options.guess)},
          {"scene", json_of(input.scene)},
          {"projection", newton::projection_name(options.newton.projection)},
          {"solver", solver},
          {"mesh", mesh_json(input.key_shapes)},
          {"warnings", warnings},
          {"frames", frames},
          {"seconds",
           {{"total", facts.total}, {"read", facts.read}, {"solve", facts.solve}, {"write", facts.write}}},
          {"threads", facts.threads},
          {"instruction_set", isa_name(active_isa())},
          {"version", version_string}};
}

}  // namespace isostretch::reports
