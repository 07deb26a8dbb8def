#include "interpolate.hpp"

#include "common/animation.hpp"
#include "common/check_report.hpp"
#include "common/monitor.hpp"
#include "common/scene_input.hpp"
#include "common/sequence_report.hpp"
#include "common/terminal.hpp"
#include "common/timed.hpp"
#include "report.hpp"

#include <isostretch/core/text.hpp>
#include <isostretch/core/timer.hpp>
#include <isostretch/scene/energy.hpp>
#include <isostretch/surface/edges.hpp>

#include <algorithm>
#include <utility>

namespace isostretch::app::interpolate {
namespace {

// Frames to draw side by side, evenly over the way.
bool is_drawn(int frame, int frames) {
  constexpr int intervals = 4;
  for (int i = 0; i <= intervals; ++i)
    if (frame == (2 * i * frames + intervals) / (2 * intervals)) return true;
  return false;
}

// Prints what is to be known of both poses, and whether they belong together: ExitCode::input if not.
ExitCode check_poses(const Options& options) {
  return with_error_kind(ErrorKind::input, [&] {
    SolidSpec spec;
    spec.repair = options.repair;
    spec.file = options.first;
    SolidCheck a = deformation::check_solid(spec);
    spec.file = options.second;
    SolidCheck b = deformation::check_solid(spec);
    const ExitCode codes[] = {print_check(a), print_check(b)};
    if (codes[0] != ExitCode::success || codes[1] != ExitCode::success) return ExitCode::input;
    try {
      deformation::require_pair({std::move(*a.body), std::move(*b.body)}, options.first.string(),
                                options.second.string());
    } catch (const Error& error) {
      print(std::string("The poses do not belong together: ") + error.what() + "\n");
      return ExitCode::input;
    }
    print("The poses belong together.\n");
    return ExitCode::success;
  });
}

class Job {
 public:
  Job(const std::filesystem::path& input, Options options, const CommonOptions& common)
      : options_(std::move(options)),
        common_(common),
        key_shapes_(timed(seconds_.read,
                          [&] {
                            return with_error_kind(ErrorKind::input, [&] {
                              return deformation::read_key_shapes(options_.first, options_.second,
                                                                  options_.repair);
                            });
                          })),
        energy_(reading_scene(input, [&] { return read_energy(); })),
        strains_{Strain(key_shapes_.first.elements), Strain(key_shapes_.second.elements)},
        interpolator_(options_, key_shapes_, energy_, terminal_monitor()),
        animation_(key_shapes_.first, outline(key_shapes_.first)),
        result_{options_, key_shapes_, energy_} {
    if (!energy_.has_barrier())
      warn_of("'" + energy_.name() + "' has no barrier: frames may have inverted elements");
  }

  ExitCode run() {
    OutputFolder folder(options_.out);
    timed(seconds_.solve, [&] { make_frames(); });
    timed(seconds_.write, [&] { write_frames(folder); });
    if (jumps_at_the_end(result_))
      warn_of(
          "the last step is much longer than the others: the way leads to another minimum than the second "
          "pose");
    write_reports(folder);
    return conclude(verdict(result_), exit_code(result_), folder, options_.out, common_.verbose);
  }

 private:
  energies::AnyEnergy read_energy() const {
    require_holds(options_.format, key_shapes_.first);
    energies::AnyEnergy energy = scene::read_energy(scene::Node(options_.value), key_shapes_.first.dim);
    deformation::require_least_at_rest(energy, key_shapes_.first.dim);
    return energy;
  }

  static std::vector<std::array<int, 2>> outline(const SolidModel& body) {
    if (body.dim == 3) return {};
    return mesh::edges_of(body.surface.mesh.triangles).boundary;
  }

  void warn_of(std::string text) {
    warn(text);
    result_.warnings.push_back(std::move(text));
  }

  void make_frames() {
    for (int number = 0; !interpolator_.done(); ++number) {
      if (interrupted() && number > 0) {
        result_.outcome = Outcome::stopped;
        result_.message = formatted("interrupted (Ctrl-C) before frame %d", number);
        return;
      }
      frames_.push_back(interpolator_.next());
      clear_progress();
      const deformation::InterpolationFrame& frame = frames_.back();
      const Strains strains{strains_[0].at(frame.settled), strains_[1].at(frame.settled)};
      add_frame(result_, frame, strains, frame_name(number, options_.format));
      if (frame.solved) notice(progress(frame, strains));
      if (frame.complete()) continue;
      result_.outcome = newton::failed(frame.summary.status) ? Outcome::failed : Outcome::stopped;
      result_.message = formatted("frame %d: ", number) + frame.summary.message;
      return;
    }
  }

  // Only now is known how all of them lie.
  void write_frames(OutputFolder& folder) {
    for (const deformation::InterpolationFrame& frame : frames_) {
      const Vector positions = interpolator_.placed(frame);
      const StrainField first = strains_[0].at(positions), second = strains_[1].at(positions);
      folder.write_now(frame_name(frame.number, options_.format),
                       format_frame(options_.format, key_shapes_.first, positions,
                                    {{"min_det_F_1", first.min_det},
                                     {"min_det_F_2", second.min_det},
                                     {"length_change_1", first.length_change},
                                     {"length_change_2", second.length_change}}));
      animation_.add(frame.number, frame.time, positions, first);
      take_snapshot({frame.number, frame.time, positions});
    }
  }

  // The last one stays only until there is a later one, unless it is among those to draw.
  void take_snapshot(Snapshot shot) {
    auto& shots = result_.snapshots;
    if (!shots.empty() && !is_drawn(shots.back().number, options_.frames)) shots.pop_back();
    shots.push_back(std::move(shot));
  }

  std::string progress(const deformation::InterpolationFrame& frame, const Strains& strains) const {
    return formatted("frame %d of %d: %s, %d iterations, min det F %.3g and %.3g, %.3f s", frame.number,
                     options_.frames, frame.summary.converged() ? "converged" : frame.summary.message.c_str(),
                     frame.summary.iterations, strains[0].smallest_det(), strains[1].smallest_det(),
                     frame.seconds);
  }

  void add_glb(OutputFolder& folder) {
    std::string told = animation_.add_glb(folder, "interpolation");
    if (!told.empty()) warn_of(std::move(told));
  }

  void write_reports(OutputFolder& folder) {
    std::string frames, energies;
    timed(seconds_.write, [&] {
      if (options_.pictures) {
        folder.add("interpolation.png", frames = draw_frames(result_));
        folder.add("energy.png", energies = draw_energies(result_));
      }
      if (options_.glb) add_glb(folder);
      folder.add("trace.csv", result_.trace);
      if (options_.format == FrameFormat::vtu)
        folder.add("interpolation.pvd", animation_text(result_.frames));
    });
    seconds_.total = timer_.seconds();
    const Json summary = summary_json(result_, seconds_);
    folder.add_json("summary.json", summary);
    if (options_.pictures)
      folder.add("report.html", report_page(result_, summary, frames, energies, animation_.preview()));
    folder.commit();
  }

  Timer timer_;
  PhaseSeconds seconds_;
  Options options_;
  const CommonOptions& common_;
  deformation::KeyShapes key_shapes_;
  energies::AnyEnergy energy_;
  std::array<Strain, 2> strains_;
  deformation::Interpolation interpolator_;
  Animation animation_;
  std::vector<deformation::InterpolationFrame> frames_;
  Result result_;
};

}  // namespace

ExitCode interpolate(const CommandLine& command_line, const CommonOptions& common) {
  Options options = command_line.options();
  if (options.check) return check_poses(options);
  return Job(command_line.input(), std::move(options), common).run();
}

}  // namespace isostretch::app::interpolate
