#include "fake_programs.hpp"
#include "reference_problems.hpp"

#include <isostretch/baselines/solver.hpp>
#include <isostretch/core/timer.hpp>

#include <doctest/doctest.h>

#include <cmath>

namespace {

using namespace isostretch;
using baselines::Result;
using baselines::Status;

const tests::Reference& reference_named(const std::string& name) {
  static const std::vector<tests::Reference> all = tests::references();
  const auto found = std::find_if(all.begin(), all.end(), [&](const auto& r) { return r.name == name; });
  REQUIRE(found != all.end());
  return *found;
}

baselines::Instance instance_named(const std::string& name) {
  return {reference_named(name).problem, reference_named(name).rest};
}

bool available(std::string_view name) {
  for (const auto& info : baselines::solvers())
    if (info.name == name && !info.available()) {
      MESSAGE(name, " left out, for want of ", info.needs);
      return false;
    }
  return true;
}

// Runs in a folder of its own, and looks whether anything stayed there.
Result run(std::string_view name, const baselines::Instance& instance, baselines::Options options = {}) {
  const baselines::TemporaryFolder folder({});
  options.temporary_folder = folder.path();
  Result result = baselines::solve(name, instance, options);
  CHECK(std::filesystem::is_empty(folder.path()));
  return result;
}

// A square of two triangles whose corners are held in mirrored places.
baselines::Instance impossible_instance() {
  sdp_penalty::Problem problem;
  problem.elements.dim = 2;
  problem.elements.nodes_per_element = 3;
  problem.elements.points_per_element = 1;
  problem.elements.node_count = 4;
  problem.elements.nodes = {0, 1, 2, 0, 2, 3};
  problem.elements.gradients = {-1, 0, 1, -1, 0, 1, 0, -1, 1, 0, -1, 1};
  problem.elements.weights = {0.5, 0.5};
  problem.rotations = {1, 0, 0, 1, 1, 0, 0, 1};
  problem.weights = {1, 1};
  problem.targets = {{0, {0, 0}, true}, {1, {-1, 0}, true}, {2, {-1, 1}, true}};
  baselines::Instance instance{problem, Vector(8)};
  instance.rest << 0, 0, 1, 0, 1, 1, 0, 1;
  return instance;
}

// What each of the programs reached where it was measured, times three.
struct Accuracy {
  std::string name;
  double difference;
};
const Accuracy accuracies[] = {{"csdp", 1e-6}, {"sdpa", 5e-7}, {"dsdp", 2e-8}};

TEST_CASE("Programs find the reference optima") {
  for (const auto& [name, difference] : accuracies) {
    if (!available(name)) continue;
    for (const char* instance : {"yogurt90_N6_r0.15", "bar3d_squash_8x2x2"}) {
      CAPTURE(name);
      CAPTURE(instance);
      const double optimum = reference_named(instance).json["sdp"]["E_upper"];
      const Result result = run(name, instance_named(instance));
      CHECK(result.status == Status::converged);
      CHECK(std::abs(result.measures.energy - optimum) <= difference * optimum);
      CHECK(result.measures.min_eigenvalue >= -1e-7);
      CHECK(result.measures.inverted == 0);
      CHECK(result.iterations > 5);
      CHECK(result.iterations < 100);
      CHECK(result.peak_megabytes > 1);
      CHECK(result.trace.size() == 1);
      CHECK(result.seconds.modelling > 0);
      CHECK(result.seconds.solving > 0);
      CHECK(result.seconds.reading > 0);
    }
  }
}

TEST_CASE("Programs know hard targets, weights, incompressibility, the margin and bounds on stretch") {
  baselines::Instance instance = instance_named("yogurt90_N6_r0.15");
  sdp_penalty::Problem& problem = instance.problem;
  problem.margin = 0.1;
  problem.incompressibility = 3;
  problem.largest_stretch = 1.5;
  for (std::size_t e = 0; e < problem.weights.size(); ++e) problem.weights[e] = 0.5 + 0.1 * double(e % 7);
  problem.targets[0].hard = true;
  const Result ours = baselines::solve("interior_point", instance);
  REQUIRE(ours.status == Status::converged);
  for (const auto& [name, difference] : accuracies) {
    if (!available(name)) continue;
    CAPTURE(name);
    const Result result = run(name, instance);
    CHECK(result.status == Status::converged);
    CHECK(std::abs(result.measures.energy - ours.measures.energy) <= 3e-6 * ours.measures.energy);
    for (int r = 0; r < 2; ++r)
      CHECK(result.x[problem.targets[0].node * 2 + r] ==
            problem.targets[0].position[static_cast<std::size_t>(r)]);
  }
}

TEST_CASE("The tolerance and the number of iterations reach the programs") {
  for (const auto& [name, difference] : accuracies) {
    if (!available(name)) continue;
    CAPTURE(name);
    const baselines::Instance instance = instance_named("bar3d_squash_8x2x2");
    baselines::Options options;
    options.tolerance = 1e-2;
    const Result loose = run(name, instance, options);
    CHECK(loose.status == Status::converged);
    options.limits.iterations = 5;
    const Result limited = run(name, instance, options);
    CHECK(limited.status == Status::iteration_limit);
    CHECK(limited.iterations <= 6);
    CHECK(loose.iterations > 6);
    CHECK(loose.iterations < run(name, instance).iterations);
  }
}

TEST_CASE("Programs claim that an impossible problem is infeasible, and leave no optimum") {
  for (const auto& [name, difference] : accuracies) {
    if (!available(name)) continue;
    CAPTURE(name);
    CHECK(run(name, impossible_instance()).status == Status::claims_infeasible);
  }
}

TEST_CASE("A program that is not in PATH is unavailable, and says which package has it") {
  const tests::FakePrograms programs;
  programs.hide_the_others();
  const Result result = run("csdp", instance_named("yogurt90_N6_r0.15"));
  CHECK(result.status == Status::unavailable);
  CHECK(result.message == "program csdp (Debian: coinor-csdp) in PATH");
  CHECK_FALSE(result.has_positions());
}

TEST_CASE("Whatever a program does, there is a status, and nothing stays behind") {
  const tests::FakePrograms programs;
  const baselines::Instance instance = instance_named("yogurt90_N6_r0.15");
  baselines::Options options;
  const auto outcome = [&](const std::string& script) {
    for (const char* command : {"csdp", "sdpa", "dsdp5"}) programs.add(command, script);
    Result last;
    for (const char* name : {"csdp", "sdpa", "dsdp"}) {
      CAPTURE(script);
      CAPTURE(name);
      Result result = run(name, instance, options);
      CHECK_FALSE(result.has_positions());
      CHECK_FALSE(result.message.empty());
      if (last.status != Status::not_run) CHECK(result.status == last.status);
      last = std::move(result);
    }
    return last;
  };

  SUBCASE("crash") {
    const Result result = outcome("kill -SEGV $$");
    CHECK(result.status == Status::crashed);
    CHECK(result.message == "ended by signal 11");
  }
  SUBCASE("crash after a verdict") {
    CHECK(outcome("echo 'Success: SDP solved'; echo 'DSDP Converged.'; echo 'phase.value = pdOPT' > p.out; "
                  "kill -SEGV $$")
              .status == Status::crashed);
  }
  SUBCASE("an error of its own") {
    const Result result = outcome("echo 'cannot do this'; exit 1");
    CHECK(result.status == Status::failed);
    CHECK(result.message == "exit code 1: cannot do this");
  }
  SUBCASE("nothing, or garbage") {
    CHECK(outcome("true").status == Status::unreadable);
    CHECK(outcome("head -c 5000 /dev/urandom | tee p.out").status == Status::unreadable);
  }
  SUBCASE("truncated, or no numbers") {
    const std::string verdicts = "echo 'Success: SDP solved'; echo 'DSDP Converged.'; ";
    CHECK(outcome(verdicts + "echo 'phase.value = pdOPT' > p.out").status == Status::unreadable);
    CHECK(outcome(verdicts + "printf '1 2 3 \\nphase.value = pdOPT\\nxVec =\\n{1, 2, 3' > p.out").status ==
          Status::unreadable);
    const std::string numbers = "n=0; while [ $n -lt 343 ]; do printf 'nan '; n=$((n+1)); done";
    CHECK(outcome(verdicts + "(" + numbers + "; printf '\\nphase.value = pdOPT\\nxVec =\\n{'; " + numbers +
                  ") > p.out")
              .status == Status::unreadable);
  }
  SUBCASE("no end") {
    options.limits.seconds = 0.1;
    const Timer timer;
    CHECK(outcome("sleep 1000").status == Status::time_limit);
    CHECK(timer.seconds() < 3);
  }
  SUBCASE("no memory") {
    options.limits.megabytes = 100;
    CHECK(outcome("head -c 400m /dev/zero | tail -n 1 > p.out").status == Status::memory_limit);
  }
}

TEST_CASE("No place for files is a failure with the place") {
  if (!available("csdp")) return;
  baselines::Options options;
  options.temporary_folder = "/nonexistent";
  const Result result = baselines::solve("csdp", instance_named("yogurt90_N6_r0.15"), options);
  CHECK(result.status == Status::failed);
  CHECK(result.message == "cannot make a folder in /nonexistent: No such file or directory");
}

}  // namespace
