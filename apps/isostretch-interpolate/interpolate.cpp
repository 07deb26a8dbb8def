#include "interpolate.hpp"

#include "common/monitor.hpp"
#include "common/results.hpp"
#include "common/scene_input.hpp"
#include "common/terminal.hpp"
#include "common/threads.hpp"
#include "common/timed.hpp"

#include <isostretch/core/text.hpp>
#include <isostretch/core/timer.hpp>
#include <isostretch/figures/animation.hpp>
#include <isostretch/figures/solid_figure.hpp>
#include <isostretch/reports/interpolation_report.hpp>
#include <isostretch/scene/energy.hpp>

#include <algorithm>
#include <utility>

namespace isostretch::app::interpolate {
namespace {

using reports::InterpolationEnd;
using Strains = std::array<StrainField, 2>;  // against both key shapes

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
        key_shapes_(timed(facts_.read,
                          [&] {
                            return with_error_kind(ErrorKind::input, [&] {
                              return deformation::read_key_shapes(options_.first, options_.second,
                                                                  options_.repair);
                            });
                          })),
        energy_(reading_scene(input, [&] { return read_energy(); })),
        strains_{Strain(key_shapes_.first.elements), Strain(key_shapes_.second.elements)},
        interpolator_(options_, key_shapes_, energy_, terminal_monitor()),
        animation_(key_shapes_.first, figures::outline(key_shapes_.first)),
        report_({options_.value, options_, key_shapes_, energy_}) {
    if (!energy_.has_barrier())
      warn_of("'" + energy_.name() + "' has no barrier: frames may have inverted elements");
  }

  ExitCode run() {
    OutputFolder folder(options_.out);
    timed(facts_.solve, [&] { make_frames(); });
    timed(facts_.write, [&] { write_frames(folder); });
    if (report_.jumps_at_the_end())
      warn_of(
          "the last step is much longer than the others: the way leads to another minimum than the second "
          "pose");
    write_reports(folder);
    return conclude(report_.verdict(), exit_code_of(report_.status()), folder, options_.out, common_.verbose);
  }

 private:
  energies::AnyEnergy read_energy() const {
    require_holds(options_.format, key_shapes_.first);
    energies::AnyEnergy energy = scene::read_energy(scene::Node(options_.value), key_shapes_.first.dim);
    deformation::require_least_at_rest(energy, key_shapes_.first.dim);
    return energy;
  }

  void warn_of(std::string text) {
    warn(text);
    report_.add_warning(std::move(text));
  }

  void make_frames() {
    for (int number = 0; !interpolator_.done(); ++number) {
      if (interrupted() && number > 0) {
        report_.end(InterpolationEnd::stopped, formatted("interrupted (Ctrl-C) before frame %d", number));
        return;
      }
      frames_.push_back(interpolator_.next());
      clear_progress();
      const deformation::InterpolationFrame& frame = frames_.back();
      const Strains strains{strains_[0].at(frame.settled), strains_[1].at(frame.settled)};
      report_.add_frame(frame, strains, frame_name(number, options_.format));
      if (frame.solved) notice(progress(frame, strains));
      if (frame.complete()) continue;
      report_.end(newton::failed(frame.summary.status) ? InterpolationEnd::failed : InterpolationEnd::stopped,
                  formatted("frame %d: ", number) + frame.summary.message);
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
      report_.add_snapshot({frame.number, frame.time, positions});
    }
  }

  std::string progress(const deformation::InterpolationFrame& frame, const Strains& strains) const {
    return formatted("frame %d of %d: %s, %d iterations, min det F %.3g and %.3g, %.3f s", frame.number,
                     options_.frames, frame.summary.converged() ? "converged" : frame.summary.message.c_str(),
                     frame.summary.iterations, strains[0].smallest_det(), strains[1].smallest_det(),
                     frame.seconds);
  }

  void add_glb(OutputFolder& folder) {
    std::string told = figures::add_glb(folder, animation_, "interpolation");
    if (!told.empty()) warn_of(std::move(told));
  }

  void write_reports(OutputFolder& folder) {
    std::string frames, energies;
    timed(facts_.write, [&] {
      if (options_.pictures) {
        const figures::InterpolationFigure figure = report_.figure();
        folder.add("interpolation.png", frames = figures::draw_frames(figure));
        folder.add("energy.png", energies = figures::draw_energies(figure));
      }
      if (options_.glb) add_glb(folder);
      folder.add("trace.csv", report_.trace_text());
      if (options_.format == FrameFormat::vtu) folder.add("interpolation.pvd", report_.animation_text());
    });
    facts_.total = timer_.seconds();
    folder.add("summary.json", report_.summary_text(facts_));
    if (options_.pictures)
      folder.add("report.html", report_.page(facts_, frames, energies, animation_.preview()));
    folder.commit();
  }

  Timer timer_;
  reports::RunFacts facts_{.threads = thread_count()};
  Options options_;
  const CommonOptions& common_;
  deformation::KeyShapes key_shapes_;
  energies::AnyEnergy energy_;
  std::array<Strain, 2> strains_;
  deformation::Interpolation interpolator_;
  figures::Animation animation_;
  std::vector<deformation::InterpolationFrame> frames_;
  reports::InterpolationReport report_;
};

}  // namespace

ExitCode interpolate(const CommandLine& command_line, const CommonOptions& common) {
  Options options = command_line.options();
  if (options.check) return check_poses(options);
  return Job(command_line.input(), std::move(options), common).run();
}

}  // namespace isostretch::app::interpolate
