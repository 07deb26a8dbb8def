#include <isostretch/comparison/solver_benchmark.hpp>
#include <isostretch/core/error.hpp>
#include <isostretch/core/log.hpp>
#include <isostretch/core/text.hpp>

#include <utility>

namespace isostretch::comparison {

namespace fs = std::filesystem;

SolverBenchmark::SolverBenchmark(scene::Value scene, const fs::path& folder, std::string name,
                                 const deformation::SolidModel& body, SolverBenchmarkOptions options)
    : scene_(std::move(scene)), options_(std::move(options)), chosen_(choose_solvers(options_.solvers)) {
  take_solver_keys();
  name_files_from_anywhere(folder);
  comparison_.name = std::move(name);
  comparison_.mesh = {body.name, static_cast<int>(body.nodes.rows()),
                      static_cast<int>(body.elements.element_count()), body.fingerprint()};
  comparison_.repetitions = options_.repetitions;
  comparison_.threads = options_.thread_count;
  comparison_.time_limit = options_.time_limit;
  comparison_.memory_limit = options_.memory_limit;
  runs_ = {
      .scene_file = options_.out / "scene.json",
      .out = options_.out,
      .weights_cache = options_.weights_cache.empty() ? options_.out / "weights" : options_.weights_cache,
      .identity = comparison_.mesh.fingerprint + '\n' + scene::to_json(scene_),
      .refine = options_.refine,
      .frame = options_.frame,
      .threads = options_.threads,
      .gap = options_.gap,
      .time_limit = options_.time_limit,
      .memory_limit = options_.memory_limit};
}

void SolverBenchmark::take_solver_keys() {
  scene_.take("rival");
  if (scene::Value* group = scene_.find("manipulation"); group != nullptr)
    for (const char* key : {"method", "penalty", "relinearize"}) group->take(key);
}

void SolverBenchmark::name_files_from_anywhere(const fs::path& folder) {
  const auto absolute = [&](scene::Value& file) {
    if (file.is_text()) file = fs::absolute(folder / file.text()).string();
  };
  if (scene_.has("mesh")) absolute(scene_["mesh"]);
  if (!scene_.has("photo")) return;
  scene::Value& photo = scene_["photo"];
  absolute(photo.has("file") ? photo["file"] : photo);
}

void SolverBenchmark::run(OutputFolder& folder, const Monitor& monitor) {
  runs_.stop = monitor.stop;
  folder.write_now("scene.json", scene::to_json(scene_, 2) + "\n");
  find_optimum(monitor);
  for (std::size_t i = 0; i < chosen_.size() && !monitor.stop.stop_requested(); ++i) {
    monitor.show(formatted("solver %zu of %zu  ", i + 1, chosen_.size()) + std::string(chosen_[i].name));
    comparison_.candidates.push_back(runs_.candidate(chosen_[i], options_.repetitions));
    log(LogLevel::info, outcome_text(comparison_, comparison_.candidates.back()));
  }
  write(folder);
}

// Where it is not certified, errors are left unknown.
void SolverBenchmark::find_optimum(const Monitor& monitor) {
  monitor.show("the optimum");
  const SolverCandidate best = runs_.optimum();
  if (monitor.stop.stop_requested())
    throw Error(ErrorKind::stopped,
                "interrupted (Ctrl-C) before the optimum was known; the same command goes on");
  const std::string doubt = take_optimum(comparison_, best, runs_.gap);
  if (!doubt.empty()) log(LogLevel::warning, doubt);
}

void SolverBenchmark::write(OutputFolder& folder) const {
  folder.add("comparison.csv", solver_table(comparison_));
  folder.add("comparison.json", comparison_json(comparison_));
  if (!options_.picture) return;
  const std::string plots = draw_comparison(comparison_);
  folder.add("comparison.png", plots);
  folder.add("comparison.html", comparison_page(comparison_, plots));
}

std::string SolverBenchmark::verdict() const {
  return formatted("%zu of %zu solvers compared", comparison_.candidates.size(), chosen_.size()) +
         (whole() ? "" : ", interrupted (Ctrl-C); the same command goes on");
}

}  // namespace isostretch::comparison
