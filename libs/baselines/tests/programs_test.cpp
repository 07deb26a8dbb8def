#include "fake_programs.hpp"
#include "general_instances.hpp"

#include <isostretch/core/timer.hpp>

#include <doctest/doctest.h>

#include <chrono>
#include <cmath>
#include <string>
#include <thread>
#include <vector>

namespace {

using namespace isostretch;
using baselines::Result;
using baselines::Status;
using tests::instance_named;

// Runs in a folder of its own, and looks whether anything stayed there.
Result run(std::string_view name, const baselines::Instance& instance, baselines::Options options = {}) {
  const baselines::TemporaryFolder folder({});
  options.temporary_folder = folder.path();
  Result result = baselines::solve(name, instance, options);
  CHECK(std::filesystem::is_empty(folder.path()));
  return result;
}

const std::vector<std::string> all_programs = {"csdp", "sdpa", "dsdp"};

// What each reached where it was measured, times three.
double accuracy_of(const std::string& name) {
  return name == "csdp" ? 1e-6 : name == "sdpa" ? 5e-7 : 2e-8;
}

TEST_CASE("Programs find the reference optima" * tests::needs_solvers(all_programs)) {
  for (const std::string& name : all_programs) {
    for (const std::string instance : {"yogurt90_N6_r0.15", "bar3d_squash_8x2x2"}) {
      CAPTURE(name);
      CAPTURE(instance);
      const double optimum = tests::optimum_of(instance);
      const Result result = run(name, instance_named(instance));
      CHECK(result.status == Status::converged);
      CHECK(std::abs(result.measures.energy - optimum) <= accuracy_of(name) * optimum);
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

TEST_CASE("Programs know hard targets, weights, incompressibility, the margin and bounds on stretch" *
          tests::needs_solvers(all_programs)) {
  baselines::Instance instance = tests::rich_instance();
  const sdp_penalty::Problem& problem = instance.problem;
  instance.problem.largest_stretch = 1.5;
  const Result ours = baselines::solve("interior_point", instance);
  REQUIRE(ours.status == Status::converged);
  for (const std::string& name : all_programs) {
    CAPTURE(name);
    const Result result = run(name, instance);
    CHECK(result.status == Status::converged);
    CHECK(std::abs(result.measures.energy - ours.measures.energy) <= 3e-6 * ours.measures.energy);
    for (int r = 0; r < 2; ++r)
      CHECK(result.x[problem.targets[0].node * 2 + r] ==
            problem.targets[0].position[static_cast<std::size_t>(r)]);
  }
}

TEST_CASE("The tolerance and the number of iterations reach the programs" *
          tests::needs_solvers(all_programs)) {
  for (const std::string& name : all_programs) {
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
    options = {};
    CHECK(loose.iterations < run(name, instance, options).iterations);
  }
}

TEST_CASE("Programs claim that an impossible problem is infeasible, and leave no optimum" *
          tests::needs_solvers(all_programs)) {
  for (const std::string& name : all_programs) {
    CAPTURE(name);
    CHECK(run(name, tests::impossible_instance()).status == Status::claims_infeasible);
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
    options.stop = StopToken().with_time_limit(0.1);
    const Timer timer;
    CHECK(outcome("sleep 1000").status == Status::time_limit);
    CHECK(timer.seconds() < 3);
  }
  SUBCASE("stopped by the caller") {
    const Timer timer;
    const StopSource source;
    options.stop = source.token();
    std::thread user([&] {
      std::this_thread::sleep_for(std::chrono::milliseconds(100));
      source.request_stop();
    });
    CHECK(outcome("sleep 1000").status == Status::callback);
    CHECK(timer.seconds() < 3);
    user.join();
  }
  SUBCASE("too large for it") {
    const Result result = outcome("echo 'This problem is too large to be solved in 32 bit mode!'; exit 206");
    CHECK(result.status == Status::not_applicable);
    CHECK(result.message.find("too large") != std::string::npos);
  }
  SUBCASE("no memory") {
    options.limits.megabytes = 100;
    CHECK(outcome("head -c 400m /dev/zero | tail -n 1 > p.out").status == Status::memory_limit);
  }
}

TEST_CASE("No place for files is a failure with the place" * tests::needs_solvers({"csdp"})) {
  baselines::Options options;
  options.temporary_folder = "/nonexistent";
  const Result result = baselines::solve("csdp", instance_named("yogurt90_N6_r0.15"), options);
  CHECK(result.status == Status::failed);
  CHECK(result.message == "cannot make a folder in /nonexistent: No such file or directory");
}

}  // namespace

TEST_CASE("Programs solve instances whose optimum or coordinates are far beyond their own bounds" *
          tests::needs_solvers(all_programs)) {
  for (const std::string& name : all_programs) {
    for (const std::string instance_name : {"yogurt90_N6_r0.15", "bar3d_squash_8x2x2"}) {
      CAPTURE(name);
      CAPTURE(instance_name);
      const double optimum = tests::optimum_of(instance_name);
      baselines::Instance instance = instance_named(instance_name);
      const double factor = 1e7 / optimum;
      for (double& weight : instance.problem.weights) weight *= factor;
      instance.problem.alpha *= factor;
      const Result stiff = run(name, instance);
      CHECK(stiff.status == Status::converged);
      CHECK(std::abs(stiff.measures.energy - 1e7) <= 10 * accuracy_of(name) * 1e7);

      baselines::Instance large = instance_named(instance_name);
      constexpr double length = 1e8;
      for (double& g : large.problem.elements.gradients) g /= length;
      for (sdp_penalty::Target& target : large.problem.targets)
        for (double& coordinate : target.position) coordinate *= length;
      large.rest *= length;
      large.problem.alpha /= length * length;
      const Result far = run(name, large);
      CHECK(far.status == Status::converged);
      CHECK(std::abs(far.measures.energy - optimum) <= 10 * accuracy_of(name) * optimum);
    }
  }
}
