#include "deform.hpp"

#include "common/monitor.hpp"
#include "common/results.hpp"
#include "common/scene_input.hpp"
#include "common/terminal.hpp"
#include "common/threads.hpp"
#include "common/timed.hpp"
#include "scene.hpp"

#include <isostretch/core/text.hpp>
#include <isostretch/core/timer.hpp>
#include <isostretch/deformation/handle_misses.hpp>
#include <isostretch/deformation/solid_check.hpp>
#include <isostretch/figures/animation.hpp>
#include <isostretch/figures/solid_figure.hpp>
#include <isostretch/reports/sequence_report.hpp>
#include <isostretch/scene/pipelines.hpp>
#include <isostretch/scene/solid.hpp>

#include <utility>

namespace isostretch::app::deform {
namespace {

using reports::SequenceEnd;
using reports::SequenceState;

constexpr const char* state_file = "restart.json";

SolidSpec read_spec(const CommandLine& command_line, const scene::Value& value) {
  const std::filesystem::path folder = scene_folder(command_line.input());
  SolidSpec spec =
      reading_scene(command_line.input(), [&] { return scene::read_solid(scene::Node(value), folder); });
  spec.repair = command_line.repair();
  return spec;
}

Scene read_scene(const scene::Value& value, int dim) {
  const scene::Node node(value);
  Scene result{scene::read_sequence(node, dim), value};
  if (const auto format = node.find("format")) result.format = format->choice(choice_names(FrameFormat{}));
  return result;
}

ExitCode check(const CommandLine& command_line) {
  const SolidSpec spec = read_spec(command_line, command_line.scene());
  return print_check(reading_body(command_line.input(), spec, [&] { return check_solid(spec); }));
}

class Job {
 public:
  Job(const CommandLine& command_line, const CommonOptions& common)
      : options_(command_line.options()),
        common_(common),
        value_(command_line.scene()),
        body_(timed(facts_.read, [&] { return read_body(command_line); })),
        scene_(reading_scene(command_line.input(), [&] { return read_scene(value_, body_.dim); })),
        handle_set_(reading_scene(command_line.input(), [&] { return HandleSet(scene_.script, body_); })),
        problem_(timed(facts_.read,
                       [&] {
                         return reading_scene(command_line.input(), [&] {
                           return deformation::ElasticProblem(scene_, body_, handle_set_);
                         });
                       })),
        strain_(body_.elements),
        animation_(body_, figures::figure_lines(handle_set_, body_)),
        report_({value_, scene_.script, body_, handle_set_, problem_}) {
    reading_scene(command_line.input(), [&] { require_holds(scene_.format, body_); });
    warn_of_loose_components();
  }

  // The handles, before anything is solved.
  ExitCode preview() { return show_preview({handle_set_, body_, scene_.script.end}, options_.out); }

  ExitCode run() {
    SequenceState state = options_.restart ? restored() : SequenceState();
    OutputFolder folder(options_.out);
    if (!options_.restart) state = rest_state(folder);
    first_frame_ = state.frame + 1;
    timed(facts_.solve, [&] { make_frames(state, folder); });
    facts_.solve -= frame_write_seconds_;
    write_reports(folder);
    return conclude(report_.verdict(), exit_code_of(report_.status()), folder, options_.out, common_.verbose);
  }

 private:
  SolidModel read_body(const CommandLine& command_line) {
    const SolidSpec spec = read_spec(command_line, value_);
    return reading_body(command_line.input(), spec, [&] { return deformation::load_solid(spec); });
  }

  void warn_of_loose_components() {
    const std::string text =
        deformation::loose_components_text(deformation::loose_components(handle_set_, body_));
    if (!text.empty()) add_warning(text);
  }

  void add_warning(const std::string& text) {
    report_.add_warning(text);
    warn(text);
  }

  SequenceState restored() {
    SequenceState state =
        with_error_kind(ErrorKind::input, [&] { return report_.read_state(options_.out / state_file); });
    for (const std::string& text : state.warnings) warn(text);
    notice(formatted("going on after frame %d of %d", state.frame, scene_.script.frames));
    return state;
  }

  // Frame 0.
  SequenceState rest_state(OutputFolder& folder) {
    SequenceState state{0, body_.rest_positions(), {}};
    const StrainField strain = strain_.at(state.positions);
    const std::string file = frame_name(0, scene_.format);
    report_.add_rest(strain, file);
    write_frame(folder, file, state.positions, strain);
    save(folder, state);
    return state;
  }

  void make_frames(SequenceState& state, OutputFolder& folder) {
    deformation::Stepper stepper(
        scene_, body_, handle_set_, problem_, [this](const std::string& text) { add_warning(text); },
        terminal_monitor());
    positions_ = state.positions;
    animation_.add(state.frame, scene_.script.time(state.frame), state.positions,
                   strain_.at(state.positions));
    for (int frame = state.frame + 1; frame <= scene_.script.frames; ++frame) {
      if (interrupted())
        return report_.end(SequenceEnd::stopped, formatted("interrupted (Ctrl-C) before frame %d", frame));
      if (options_.stop_after >= 0 && frame > first_frame_ + options_.stop_after - 1)
        return report_.end(SequenceEnd::stop_after, formatted("stopped after frame %d of %d (--stop-after)",
                                                              frame - 1, scene_.script.frames));
      if (!make_frame(frame, stepper, folder, state)) return;
    }
  }

  // False when it was not reached; `state` then stays at the frame before.
  bool make_frame(int frame, deformation::Stepper& stepper, OutputFolder& folder, SequenceState& state) {
    Vector positions = state.positions;
    const deformation::FrameResult made = stepper.advance(frame, positions);
    clear_progress();
    const StrainField strain = strain_.at(positions);
    const bool moved = made.parts > 0;  // there is something to show
    const std::string file = frame_name(frame, scene_.format);
    if (moved) {
      last_misses_ = deformation::handle_misses(handle_set_, made.time, body_.dim, positions);
      report_.add_frame(frame, made, strain, last_misses_, file);
      positions_ = positions;
      write_frame(folder, file, positions, strain);
      animation_.add(frame, made.time, positions, strain);
    }
    if (!made.reached) {
      const bool failed = !made.why.empty() || newton::failed(made.summary.status);
      report_.end(failed ? SequenceEnd::failed : SequenceEnd::stopped,
                  made.why.empty() ? formatted("frame %d: ", frame) + made.summary.message : made.why);
      return false;
    }
    state = {frame, std::move(positions), {}};
    save(folder, state);
    notice(progress(frame, made, strain));
    return true;
  }

  std::string progress(int frame, const deformation::FrameResult& made, const StrainField& strain) const {
    return formatted("frame %d of %d: %s, %d iterations, min det F %.3g, %.2f s", frame, scene_.script.frames,
                     made.summary.converged() ? "converged" : made.summary.message.c_str(),
                     made.summary.iterations, strain.smallest_det(), made.seconds);
  }

  void write_frame(OutputFolder& folder, const std::string& file, const Vector& positions,
                   const StrainField& strain) {
    const ScopedTimer timer(frame_write_seconds_);
    std::vector<mesh::MeshField> fields{{"min_det_F", strain.min_det},
                                        {"length_change", strain.length_change},
                                        {"stress_norm", problem_.stress_norms(strain)}};
    if (problem_.regions().size() > 1) fields.push_back({"region", problem_.region_numbers()});
    folder.write_now(file, format_frame(scene_.format, body_, positions, fields));
  }

  void save(OutputFolder& folder, const SequenceState& state) {
    const ScopedTimer timer(frame_write_seconds_);
    folder.write_now(state_file, report_.state_text(state.frame, state.positions));
  }

  // Of the last frame. Stretches go with an energy; handles that are not where they should be go with its
  // weights.
  void warn_of_misses() {
    for (const std::string& text : deformation::miss_warnings(last_misses_, body_.diagonal()))
      add_warning("the last frame: " + text);
  }

  void add_glb(OutputFolder& folder) {
    const std::string told = figures::add_glb(folder, animation_, "deform");
    if (!told.empty()) add_warning(told);
  }

  void write_reports(OutputFolder& folder) {
    warn_of_misses();
    std::string picture;
    timed(facts_.write, [&] {
      if (options_.picture)
        folder.add("deform.png", picture = figures::draw_sequence(report_.figure(positions_)));
      folder.add("trace.csv", report_.trace_text());
      if (scene_.format == FrameFormat::vtu) folder.add("deform.pvd", report_.animation_text());
      if (options_.glb) add_glb(folder);
    });
    facts_.write += frame_write_seconds_;
    facts_.total = timer_.seconds();
    folder.add("summary.json", report_.summary_text(facts_));
    if (options_.picture) folder.add("report.html", report_.page(facts_, picture, animation_.preview()));
    folder.commit();
  }

  Timer timer_;
  reports::RunFacts facts_{.threads = thread_count()};
  double frame_write_seconds_ = 0;
  std::vector<HandleMiss> last_misses_;
  Options options_;
  const CommonOptions& common_;
  scene::Value value_;
  SolidModel body_;
  Scene scene_;
  HandleSet handle_set_;
  deformation::ElasticProblem problem_;
  Strain strain_;
  figures::Animation animation_;  // of this run: from the frame that it went on from
  reports::SequenceReport report_;
  Vector positions_;     // of the last frame
  int first_frame_ = 1;  // of those made in this run
};

}  // namespace

ExitCode deform(const CommandLine& command_line, const CommonOptions& common) {
  const LookFlags look = command_line.options().look;
  if (look.check) return check(command_line);
  Job job(command_line, common);
  return look.preview ? job.preview() : job.run();
}

}  // namespace isostretch::app::deform
