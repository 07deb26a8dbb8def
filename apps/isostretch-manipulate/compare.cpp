#include "compare.hpp"

#include "common/interrupt.hpp"
#include "common/sequence_report.hpp"
#include "common/terminal.hpp"
#include "common/threads.hpp"
#include "input.hpp"

#include <isostretch/comparison/solver_runs.hpp>
#include <isostretch/core/text.hpp>

namespace isostretch::app::manipulate {
namespace {

namespace fs = std::filesystem;

class Benchmark {
 public:
  Benchmark(const CommandLine& command_line, const CommonOptions& common)
      : common_(common), options_(command_line.options()), scene_(command_line.scene()) {
    chosen_ = with_error_kind(ErrorKind::misuse, [&] {
      return with_error_prefix("--compare", [&] { return comparison::choose_solvers(options_.compare); });
    });
    read(command_line);
    // Solvers decide on these.
    scene_.take("rival");
    if (scene::Value* group = scene_.find("manipulation"); group != nullptr)
      for (const char* key : {"method", "penalty", "relinearize"}) group->take(key);
    name_files_from_anywhere(command_line.folder());
    runs_.out = options_.out;
    runs_.scene_file = options_.out / "scene.json";
    runs_.weights_cache = options_.weights_cache.empty() ? options_.out / "weights" : options_.weights_cache;
    runs_.identity = comparison_.mesh.fingerprint + '\n' + scene::to_json(scene_);
    runs_.refine = command_line.refine();
    runs_.threads = common.threads;
    runs_.time_limit = comparison_.time_limit = options_.time_limit;
    runs_.memory_limit = comparison_.memory_limit = options_.memory_limit;
    runs_.stop = interrupt_token();
    comparison_.repetitions = options_.repetitions;
    comparison_.threads = thread_count();
  }

  ExitCode run() {
    OutputFolder folder(options_.out);
    folder.write_now("scene.json", scene::to_json(scene_, 2) + "\n");
    find_optimum();
    for (std::size_t i = 0; i < chosen_.size() && !interrupted(); ++i) {
      show_progress(formatted("solver %zu of %zu  ", i + 1, chosen_.size()) + std::string(chosen_[i].name));
      comparison_.candidates.push_back(runs_.candidate(chosen_[i], options_.repetitions));
      notice(comparison::outcome_text(comparison_, comparison_.candidates.back()));
    }
    clear_progress();
    write(folder);
    return conclude(folder);
  }

 private:
  // As a run will: what is wrong is to be said once, of the files that the user knows.
  void read(const CommandLine& command_line) {
    const SolidModel body = read_body(command_line, scene_);
    const Scene scene = read_scene(command_line, scene_, body);
    read_rig(command_line, scene, body);
    comparison_.name = command_line.has_scene_file() ? command_line.input().stem().string() : body.name;
    comparison_.mesh = {body.name, static_cast<int>(body.nodes.rows()),
                        static_cast<int>(body.elements.element_count()), body.fingerprint()};
    runs_.frame = read_range(options_, scene).last;
    runs_.gap = scene.solver.gap_tolerance;
  }

  // The scene is written to another folder.
  void name_files_from_anywhere(const fs::path& folder) {
    const auto absolute = [&](scene::Value& file) {
      if (file.is_text()) file = fs::absolute(folder / file.text()).string();
    };
    if (scene_.has("mesh")) absolute(scene_["mesh"]);
    if (!scene_.has("photo")) return;
    scene::Value& photo = scene_["photo"];
    absolute(photo.has("file") ? photo["file"] : photo);
  }

  // Where it is not certified, errors are left unknown.
  void find_optimum() {
    show_progress("the optimum");
    const comparison::SolverCandidate best = runs_.optimum();
    if (interrupted())
      throw Error(ErrorKind::stopped,
                  "interrupted (Ctrl-C) before the optimum was known; the same command goes on");
    const std::string doubt = comparison::take_optimum(comparison_, best, runs_.gap);
    if (!doubt.empty()) warn(doubt);
  }

  void write(OutputFolder& folder) const {
    folder.add("comparison.csv", comparison::solver_table(comparison_));
    folder.add("comparison.json", comparison::comparison_json(comparison_));
    if (options_.picture) {
      const std::string plots = comparison::draw_comparison(comparison_);
      folder.add("comparison.png", plots);
      folder.add("comparison.html", comparison::comparison_page(comparison_, plots));
    }
    folder.commit();
  }

  ExitCode conclude(const OutputFolder& folder) const {
    const std::size_t done = comparison_.candidates.size();
    const bool whole = done == chosen_.size();
    return app::conclude(formatted("%zu of %zu solvers compared", done, chosen_.size()) +
                             (whole ? "" : ", interrupted (Ctrl-C); the same command goes on"),
                         whole ? ExitCode::success : ExitCode::not_converged, folder, options_.out,
                         common_.verbose);
  }

  const CommonOptions& common_;
  Options options_;
  scene::Value scene_;
  comparison::SolverComparison comparison_;
  comparison::SolverRuns runs_;
  std::vector<baselines::SolverInfo> chosen_;
};

}  // namespace

ExitCode compare(const CommandLine& command_line, const CommonOptions& common) {
  return Benchmark(command_line, common).run();
}

}  // namespace isostretch::app::manipulate
