#include "registry.hpp"
#include "solver_module.hpp"

#include <isostretch/baselines/solver.hpp>
#include <isostretch/core/error.hpp>

#include <cmath>
#include <exception>
#include <new>

namespace isostretch::baselines {
namespace {

std::vector<Entry> registry() {
  std::vector<Entry> all;
  for (const auto& family :
       {own_methods, sdp_programs, ipopt_solvers, nlopt_solvers, relinearized, bounded_distortion,
        determinant_penalty, locally_injective, foldover_free, lifted_content})
    for (Entry& entry : family()) all.push_back(std::move(entry));
  return all;
}

Entry entry_named(std::string_view name) {
  std::string names;
  for (Entry& entry : registry()) {
    if (entry.info.name == name) return std::move(entry);
    names += (names.empty() ? "" : ", ") + std::string(entry.info.name);
  }
  throw Error("there is no solver '" + std::string(name) + "', there are: " + names);
}

}  // namespace

void Options::validate() const {
  const auto require = [](bool condition, const char* text) {
    if (!condition) throw Error(std::string("solver options: ") + text);
  };
  require(tolerance > 0 && tolerance < 1, "tolerance must be between 0 and 1");
  require(limits.megabytes >= 0 && std::isfinite(limits.megabytes), "limits.megabytes must not be negative");
  require(limits.iterations >= 0, "limits.iterations must not be negative");
}

std::vector<SolverInfo> solvers() {
  std::vector<SolverInfo> infos;
  for (Entry& entry : registry()) infos.push_back(std::move(entry.info));
  return infos;
}

Result solve(std::string_view solver, const Instance& instance, const Options& options,
             const PointCallback& callback) {
  const Entry entry = entry_named(solver);
  options.validate();
  instance.validate();
  Recorder recorder(instance, options, callback);
  if (!entry.info.available()) {
    recorder.end(Status::unavailable, entry.info.needs);
    return recorder.finish({});
  }
  if (instance.problem.bounds_stretch() && !entry.info.bounds_stretch) {
    recorder.end(Status::not_applicable, "it does not know largest_stretch");
    return recorder.finish({});
  }
  Vector x;
  try {
    x = entry.run(instance, options, recorder);
  } catch (const std::bad_alloc&) {
    recorder.end(Status::memory_limit, "out of memory");
  } catch (const ModuleError& error) {
    recorder.end(Status::unavailable, error.what());
  } catch (const std::exception& error) {
    const std::string what = error.what();
    const bool no_memory = what.find("out of memory") != std::string::npos;
    recorder.end(no_memory ? Status::memory_limit : Status::failed, what);
  }
  return recorder.finish(x);
}

}  // namespace isostretch::baselines
