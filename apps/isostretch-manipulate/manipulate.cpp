#include "manipulate.hpp"

#include "common/monitor.hpp"
#include "common/results.hpp"
#include "common/scene_input.hpp"
#include "common/terminal.hpp"
#include "common/threads.hpp"
#include "common/timed.hpp"
#include "input.hpp"

#include <isostretch/comparison/manipulation_run.hpp>

namespace isostretch::app::manipulate {
namespace {

class Job {
 public:
  explicit Job(const CommandLine& command_line)
      : options_(command_line.options()),
        value_(command_line.scene()),
        body_(timed(seconds_.read, [&] { return read_body(command_line, value_); })),
        scene_(read_scene(command_line, value_, body_)),
        handle_set_(read_rig(command_line, scene_, body_)),
        range_(read_range(options_, scene_)),
        photo_(reading_scene(command_line.input(),
                             [&] { return comparison::read_photo(scene_, body_, command_line.folder()); })) {}

  // The handles, before anything is solved.
  ExitCode preview() {
    if (const std::string text =
            deformation::loose_components_text(deformation::loose_components(handle_set_, body_));
        !text.empty())
      warn(text);
    return show_preview({handle_set_, body_, scene_.script.time(range_.last), scene_.up}, options_.out);
  }

  ExitCode run(const CommandLine& command_line, bool verbose) {
    OutputFolder folder(options_.out);
    if (!options_.weights_cache.empty()) const OutputFolder writable(options_.weights_cache);
    const std::string name =
        command_line.has_scene_file() ? command_line.input().stem().string() : body_.name;
    comparison::ManipulationRun run = reading_scene(command_line.input(), [&] {
      return comparison::ManipulationRun(
          scene_, body_, handle_set_,
          {range_.first, range_.last, options_.time_limit, options_.memory_limit, options_.picture,
           options_.glb, thread_count(), name, options_.weights_cache},
          seconds_, timer_);
    });
    if (photo_) run.add_photo(*std::move(photo_));
    run.run(folder, terminal_monitor());
    folder.commit();
    return conclude(run.report().verdict(), exit_code_of(run.report().status()), folder, options_.out,
                    verbose);
  }

 private:
  Timer timer_;
  comparison::ManipulationSeconds seconds_;
  Options options_;
  scene::Value value_;
  SolidModel body_;
  Scene scene_;
  HandleSet handle_set_;
  FrameRange range_;
  std::optional<figures::PhotoFrames> photo_;
};

}  // namespace

ExitCode manipulate(const CommandLine& command_line, const CommonOptions& common) {
  const LookFlags look = command_line.options().look;
  if (look.check) return print_check(check_solid(command_line, command_line.scene()));
  Job job(command_line);
  return look.preview ? job.preview() : job.run(command_line, common.verbose);
}

}  // namespace isostretch::app::manipulate
