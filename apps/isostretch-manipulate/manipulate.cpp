#include "manipulate.hpp"

#include "common/animation.hpp"
#include "common/check_report.hpp"
#include "common/handle_miss_report.hpp"
#include "common/monitor.hpp"
#include "common/preview.hpp"
#include "common/rig_figure.hpp"
#include "common/scene_input.hpp"
#include "common/sequence_report.hpp"
#include "common/terminal.hpp"
#include "common/threads.hpp"
#include "common/timed.hpp"
#include "input.hpp"
#include "picture.hpp"

#include <isostretch/comparison/manipulation_report.hpp>
#include <isostretch/core/text.hpp>
#include <isostretch/core/timer.hpp>
#include <isostretch/deformation/handle_misses.hpp>
#include <isostretch/figures/photo_frames.hpp>

#include <utility>

namespace isostretch::app::manipulate {
namespace {

using comparison::ManipulationFrame;
using comparison::ManipulationReport;
using comparison::StrainedShape;

ExitCode exit_code(comparison::ManipulationStatus status) {
  using comparison::ManipulationStatus;
  if (status == ManipulationStatus::failed) return ExitCode::solver_failed;
  return status == ManipulationStatus::success ? ExitCode::success : ExitCode::not_converged;
}

class Job {
 public:
  Job(const CommandLine& command_line, const CommonOptions& common)
      : options_(command_line.options()),
        common_(common),
        value_(command_line.scene()),
        body_(timed(seconds_.read, [&] { return read_body(command_line, value_); })),
        scene_(read_scene(command_line, value_, body_)),
        handle_set_(read_rig(command_line, scene_, body_)),
        photo_(read_photo(command_line)),
        strain_(body_.elements),
        animation_(body_, figure_lines(handle_set_, body_), scene_.up),
        range_(read_range(options_, scene_)) {}

  // The handles, before anything is solved.
  ExitCode preview() {
    if (const std::string text =
            deformation::loose_components_text(deformation::loose_components(handle_set_, body_));
        !text.empty())
      warn(text);
    return show_preview({handle_set_, body_, scene_.script.time(range_.last), scene_.up}, options_.out);
  }

  ExitCode run(const CommandLine& command_line) {
    OutputFolder folder(options_.out);
    if (!options_.weights_cache.empty()) const OutputFolder writable(options_.weights_cache);
    const deformation::ElementRotations rotations = reading_scene(command_line.input(), [&] {
      return deformation::ElementRotations(scene_, body_, handle_set_, options_.weights_cache);
    });
    seconds_.weights = rotations.seconds();
    ManipulationReport result{scene_, body_, handle_set_, rotations, name_of_run(command_line)};
    result.wanted = range_.last - range_.first + 1;
    warn_of_loose_components(result);
    timed(seconds_.write, [&] { write_rest(result, folder); });
    make_frames(result, folder);
    write_reports(result, folder);
    return conclude(result.verdict(), exit_code(result.status()), folder, options_.out, common_.verbose);
  }

 private:
  std::optional<figures::PhotoFrames> read_photo(const CommandLine& command_line) const {
    const auto spec = reading_scene(command_line.input(),
                                    [&] { return scene::read_photo_spec(value_, command_line.folder()); });
    if (!spec) return {};
    const figures::Photo photo =
        with_error_kind(ErrorKind::input, [&] { return figures::read_photo(spec->file); });
    const mesh::Points2 rest = body_.nodes.leftCols<2>();
    const figures::PhotoPlacement placement = spec->fit == scene::PhotoFit::pixels
                                                  ? figures::unit_pixels(photo)
                                                  : figures::filling_box(photo, rest);
    return figures::PhotoFrames(photo, placement, body_.surface.mesh.triangles, rest);
  }

  std::string name_of_run(const CommandLine& command_line) const {
    return command_line.has_scene_file() ? command_line.input().stem().string() : body_.name;
  }

  static void add_warning(ManipulationReport& result, const std::string& text) {
    result.warnings.push_back(text);
    warn(text);
  }

  void warn_of_loose_components(ManipulationReport& result) const {
    const std::string text =
        deformation::loose_components_text(deformation::loose_components(handle_set_, body_));
    if (!text.empty()) add_warning(result, text);
  }

  void write_rest(ManipulationReport& result, OutputFolder& folder) {
    const std::string file = frame_name(0, scene_.format);
    const Vector rest = body_.rest_positions();
    const StrainField strain = strain_.at(rest);
    const std::size_t count = strain.min_det.size();
    folder.write_now(file, format_frame(scene_.format, body_, rest,
                                        {{"min_eig_S", std::vector<double>(count, 1.0)},
                                         {"det_F", strain.min_det},
                                         {"length_change", strain.length_change}}));
    result.add_rest(strain, file);
    if (range_.first == 1) animation_.add(0, scene_.script.start, rest, strain);
    if (result.rotations.weights())
      folder.write_now("weights.vtu", deformation::format_rest(
                                          body_, deformation::weight_fields(*result.rotations.weights())));
  }

  std::string stop_reason(const StopToken& stop) const {
    if (stop.stop_requested()) return "interrupted (Ctrl-C)";
    if (stop.deadline_passed())
      return formatted("stopped after %g seconds (--time-limit)", options_.time_limit);
    return {};
  }

  Json misses_of(const ManipulationFrame& frame) const {
    return misses_json(deformation::handle_misses(handle_set_, frame.time, body_.dim, frame.positions));
  }

  // Rows of the page, as the last frame that was made has them.
  std::string handle_rows(const ManipulationFrame& last) const {
    Json handles = Json::array();
    for (const Handle& handle : handle_set_.handles())
      handles.push_back(
          {{"name", handle.name}, {"nodes", handle.nodes.size()}, {"kind", handle.soft ? "soft" : "hard"}});
    return last.positions.size() > 0 ? handle_table(handles, misses_of(last)) : std::string();
  }

  void make_frames(ManipulationReport& result, OutputFolder& folder) {
    const Monitor monitor = terminal_monitor().with_time_limit(options_.time_limit);
    const auto halt = [&] { return stop_reason(monitor.stop); };
    comparison::FrameSolver solver(scene_, body_, handle_set_, result.rotations, monitor,
                                   {scene_.rival, options_.memory_limit, halt});
    for (int frame = range_.first; frame <= range_.last; ++frame) {
      const std::string reason = halt();
      if (!reason.empty() && frame > range_.first) {
        result.stopped = true;
        result.message = reason + formatted(" before frame %d", frame);
        return;
      }
      ManipulationFrame made = timed(seconds_.solve, [&] { return solver.solve(frame); });
      clear_progress();
      const bool on = !made.stopped();
      if (!on) {
        result.stopped = true;
        result.message = formatted("frame %d: ", frame) + made.summary.message;
      }
      timed(seconds_.write, [&] { take(result, std::move(made), folder); });
      if (!on) return;
    }
  }

  void take(ManipulationReport& result, ManipulationFrame made, OutputFolder& folder) {
    const std::string file = frame_name(made.frame, scene_.format);
    if (!made.made()) {
      result.add(made, {}, {}, file, {});
      warn(formatted("frame %d: ", made.frame) + made.trouble);
      return;
    }
    const StrainedShape before = result.shape(strain_, made.given, made.before),
                        after = result.shape(strain_, made.rotations, made.positions);
    folder.write_now(file, format_frame(scene_.format, body_, made.positions,
                                        {{"min_eig_S", after.eigenvalues},
                                         {"det_F", after.strain.min_det},
                                         {"length_change", after.strain.length_change}}));
    result.add(made, before, after, file, comparison::Record::parse(misses_of(made).dump()));
    animation_.add(made.frame, made.time, made.positions, after.strain);
    notice(result.frame_text(made, before, after));
    if (photo_) photo_->add(made.frame, body_.points(made.positions).leftCols<2>());
    result.last = std::move(made);
  }

  void write_photos(ManipulationReport& result, OutputFolder& folder) const {
    if (!photo_) return;
    const int shrink = photo_->draw(
        [&](int frame, const std::string& png) { folder.add(formatted("photo_%04d.png", frame), png); });
    if (shrink > 1)
      add_warning(
          result,
          formatted("the photo is drawn %d times smaller: at its own scale it would be too large", shrink));
  }

  void add_glb(ManipulationReport& result, OutputFolder& folder) const {
    const std::string told = app::add_glb(folder, animation_, "manipulate");
    if (!told.empty()) add_warning(result, told);
  }

  void write_reports(ManipulationReport& result, OutputFolder& folder) {
    for (const std::string& text : result.last_warnings(strain_)) add_warning(result, text);
    std::string states, path;
    timed(seconds_.write, [&] {
      write_photos(result, folder);
      folder.add("trace.csv", to_csv(result.trace));
      if (scene_.format == FrameFormat::vtu) folder.add("manipulate.pvd", pvd_text(result.files()));
      if (options_.glb) add_glb(result, folder);
      if (!options_.picture || result.last.positions.size() == 0) return;
      folder.add("manipulate.png", states = draw_states(result, strain_));
      folder.add("path.png", path = draw_path(result, strain_));
    });
    seconds_.total = timer_.seconds();
    folder.add("summary.json", comparison::summary_text(result, seconds_, thread_count()));
    if (options_.picture)
      folder.add("report.html", comparison::report_page(result, seconds_, states, path, animation_.preview(),
                                                        handle_rows(result.last)));
    folder.commit();
  }

  Timer timer_;
  comparison::ManipulationSeconds seconds_;
  Options options_;
  const CommonOptions& common_;
  scene::Value value_;
  SolidModel body_;
  Scene scene_;
  HandleSet handle_set_;
  std::optional<figures::PhotoFrames> photo_;
  Strain strain_;
  figures::Animation animation_;
  FrameRange range_;
};

}  // namespace

ExitCode manipulate(const CommandLine& command_line, const CommonOptions& common) {
  const LookFlags look = command_line.options().look;
  if (look.check) return print_check(check_solid(command_line, command_line.scene()));
  Job job(command_line, common);
  return look.preview ? job.preview() : job.run(command_line);
}

}  // namespace isostretch::app::manipulate
