#include "manipulate.hpp"
#include "common/check_report.hpp"
#include "frame.hpp"

#include "common/animation.hpp"
#include "common/preview.hpp"
#include "common/rig_figure.hpp"
#include "common/scene_input.hpp"
#include "common/sequence_report.hpp"
#include "common/terminal.hpp"
#include "common/timed.hpp"
#include "input.hpp"
#include "photo_frames.hpp"
#include "report.hpp"
#include "scene_reader.hpp"

#include <isostretch/core/text.hpp>
#include <isostretch/core/timer.hpp>
#include <isostretch/deformation/handle_misses.hpp>

#include <utility>

namespace isostretch::app::manipulate {
namespace {

// Frames that have a file.
Json files_of(const Json& frames) {
  Json files = Json::array();
  for (const Json& frame : frames)
    if (frame.contains("file")) files.push_back(frame);
  return files;
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
    Result result{scene_, body_, handle_set_, rotations, name_of_run(command_line)};
    result.wanted = range_.last - range_.first + 1;
    warn_of_loose_components(result);
    timed(seconds_.write, [&] { write_rest(result, folder); });
    make_frames(result, folder);
    write_reports(result, folder);
    return conclude(verdict(result), exit_code(result), folder, options_.out, common_.verbose);
  }

 private:
  std::optional<PhotoFrames> read_photo(const CommandLine& command_line) const {
    const auto spec =
        reading_scene(command_line.input(), [&] { return read_photo_spec(value_, command_line.folder()); });
    if (!spec) return {};
    return with_error_kind(ErrorKind::input,
                           [&] { return std::optional<PhotoFrames>(std::in_place, *spec, body_); });
  }

  std::string name_of_run(const CommandLine& command_line) const {
    return command_line.has_scene_file() ? command_line.input().stem().string() : body_.name;
  }

  static void add_warning(Result& result, const std::string& text) {
    result.warnings.push_back(text);
    warn(text);
  }

  void warn_of_loose_components(Result& result) const {
    const std::string text =
        deformation::loose_components_text(deformation::loose_components(handle_set_, body_));
    if (!text.empty()) add_warning(result, text);
  }

  void write_rest(Result& result, OutputFolder& folder) {
    const std::string file = frame_name(0, scene_.format);
    const Vector rest = body_.rest_positions();
    const StrainField strain = strain_.at(rest);
    const std::size_t count = strain.min_det.size();
    folder.write_now(file, format_frame(scene_.format, body_, rest,
                                        {{"min_eig_S", std::vector<double>(count, 1.0)},
                                         {"det_F", strain.min_det},
                                         {"length_change", strain.length_change}}));
    add_rest_frame(result, strain, file);
    if (range_.first == 1) animation_.add(0, scene_.script.start, rest, strain);
    if (result.rotations.weights())
      folder.write_now("weights.vtu",
                       deformation::format_rest(body_, weight_fields(*result.rotations.weights())));
  }

  std::vector<mesh::MeshField> weight_fields(const handles::HandleWeights& weights) const {
    std::vector<mesh::MeshField> fields;
    const auto count = static_cast<std::size_t>(weights.handles);
    for (std::size_t h = 0; h < count; ++h) {
      fields.push_back({"weight_" + std::to_string(h), {}});
      for (std::size_t i = h; i < weights.values.size(); i += count)
        fields.back().values.push_back(weights.values[i]);
    }
    return fields;
  }

  void make_frames(Result& result, OutputFolder& folder) {
    FrameSolver solver(scene_, body_, handle_set_, result.rotations, options_);
    for (int frame = range_.first; frame <= range_.last; ++frame) {
      const std::string reason = solver.halt();
      if (!reason.empty() && frame > range_.first) {
        result.outcome = Outcome::stopped;
        result.message = reason + formatted(" before frame %d", frame);
        return;
      }
      FrameResult made = timed(seconds_.solve, [&] { return solver.solve(frame); });
      const bool on = !made.stopped();
      if (!on) {
        result.outcome = Outcome::stopped;
        result.message = formatted("frame %d: ", frame) + made.summary.message;
      }
      timed(seconds_.write, [&] { take(result, std::move(made), folder); });
      if (!on) return;
    }
  }

  void take(Result& result, FrameResult made, OutputFolder& folder) {
    const std::string file = frame_name(made.frame, scene_.format);
    if (!made.made()) {
      add_frame(result, made, {}, {}, file);
      warn(formatted("frame %d: ", made.frame) + made.trouble);
      return;
    }
    const Shape before = shape_of(result, strain_, made.given, made.before),
                after = shape_of(result, strain_, made.rotations, made.positions);
    folder.write_now(file, format_frame(scene_.format, body_, made.positions,
                                        {{"min_eig_S", after.eigenvalues},
                                         {"det_F", after.strain.min_det},
                                         {"length_change", after.strain.length_change}}));
    add_frame(result, made, before, after, file);
    animation_.add(made.frame, made.time, made.positions, after.strain);
    notice(formatted("frame %d of %d: ", made.frame, scene_.script.frames) +
           (made.certified() ? "certified" : std::string(made.status()) + " (" + made.summary.message + ")") +
           formatted(", %d iterations", made.summary.iterations) +
           (made.rival ? std::string() : formatted(", gap %.1e", made.summary.gap)) +
           formatted(", inverted %zu -> %zu, min det F %.2g, %.2f s", before.strain.inverted.size(),
                     after.strain.inverted.size(), after.strain.smallest_det(), made.seconds));
    if (photo_) photo_->add(made.frame, made.positions);
    result.last = std::move(made);
  }

  void write_photos(Result& result, OutputFolder& folder) const {
    if (!photo_) return;
    const int shrink = photo_->write(folder);
    if (shrink > 1)
      add_warning(
          result,
          formatted("the photo is drawn %d times smaller: at its own scale it would be too large", shrink));
  }

  // Of the last frame: what a certificate does not say.
  void warn_of_misses(Result& result) const {
    const FrameResult& last = result.last;
    if (last.positions.size() == 0) return;
    const std::string frame = formatted("frame %d: ", last.frame);
    for (const std::string& text : deformation::miss_warnings(
             deformation::handle_misses(handle_set_, last.time, body_.dim, last.positions), body_.diagonal()))
      add_warning(result, frame + text);
    const StrainField strain = strain_.at(last.positions);
    const std::string flat =
        deformation::nearly_flat_text(deformation::nearly_flat_elements(strain), strain, body_);
    if (!flat.empty()) add_warning(result, frame + flat + "; --margin keeps elements from it");
  }

  void add_glb(Result& result, OutputFolder& folder) const {
    const std::string told = animation_.add_glb(folder, "manipulate");
    if (!told.empty()) add_warning(result, told);
  }

  void write_reports(Result& result, OutputFolder& folder) {
    warn_of_misses(result);
    std::string states, path;
    timed(seconds_.write, [&] {
      write_photos(result, folder);
      folder.add("trace.csv", to_csv(result.trace));
      if (scene_.format == FrameFormat::vtu)
        folder.add("manipulate.pvd", animation_text(files_of(result.frames)));
      if (options_.glb) add_glb(result, folder);
      if (!options_.picture || result.last.positions.size() == 0) return;
      folder.add("manipulate.png", states = draw_states(result, strain_));
      folder.add("path.png", path = draw_path(result, strain_));
    });
    seconds_.total = timer_.seconds();
    const Json summary = summary_json(result, seconds_);
    folder.add_json("summary.json", summary);
    if (options_.picture)
      folder.add("report.html", report_page(result, summary, states, path, animation_.preview()));
    folder.commit();
  }

  Timer timer_;
  PhaseSeconds seconds_;
  Options options_;
  const CommonOptions& common_;
  scene::Value value_;
  SolidModel body_;
  Scene scene_;
  HandleSet handle_set_;
  std::optional<PhotoFrames> photo_;
  Strain strain_;
  Animation animation_;
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
