#include <isostretch/comparison/method_comparison.hpp>
#include <isostretch/comparison/method_tables.hpp>
#include <isostretch/comparison/method_verdicts.hpp>
#include <isostretch/comparison/number_table.hpp>
#include <isostretch/core/error.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <string>
#include <vector>

using namespace isostretch;
using namespace isostretch::comparison;

namespace {

// Energies 2, 1.5, 1 + 1e-7 and 1 after 0, 1, 2 and 3 times that many seconds.
MethodRun run_of(int repetition, double seconds) {
  MethodRun run;
  run.repetition = repetition;
  run.status = "converged";
  run.converged = true;
  run.seconds = 3 * seconds;
  run.summary = Record::parse(R"({"energy": 1, "iterations": 3, "seconds": {"minimize": 6, "assembly": 3}})");
  const std::vector<double> energies{2, 1.5, 1 + 1e-7, 1};
  for (int i = 0; i < 4; ++i)
    run.trace.push_back({double(i), i * seconds, energies[i], std::pow(10.0, -2 * i)});
  return run;
}

// The first two methods there are; the second takes half as long.
ComparedProblem two_candidates() {
  ComparedProblem problem;
  problem.name = "two";
  problem.facts = Record::parse(R"({"energy": "e", "elements": 2})");
  problem.optimum = 1;
  problem.polished = true;
  for (int m = 0; m < 2; ++m) {
    MethodCandidate candidate;
    candidate.info = baselines::methods()[static_cast<std::size_t>(m)];
    for (int repetition = 1; repetition <= 3; ++repetition)
      candidate.runs.push_back(run_of(repetition, repetition / (1.0 + m)));
    problem.candidates.push_back(candidate);
  }
  return problem;
}

MethodComparison comparison_of_two() {
  MethodComparison comparison;
  comparison.settings.repetitions = 3;
  comparison.problems.push_back(two_candidates());
  return comparison;
}

}  // namespace

TEST_CASE("tables of numbers: names on top, cut off lines left out") {
  const NumberTable table("a,b\n1,2\n3,\n4\n5,x\n6,7,8\n");
  REQUIRE(table.rows() == 3);
  CHECK(table.at(0, "b") == 2);
  CHECK(std::isnan(table.at(1, "b")));
  CHECK(table.at(2, "a") == 5);
  CHECK(std::isnan(table.at(0, "c")));
  CHECK(NumberTable("").rows() == 0);
}

TEST_CASE("a record keeps the order of keys and whole numbers; of a text cut off it is null") {
  const std::string text = R"({"b":1,"a":1.0,"c":{"d":"x"},"e":true})";
  const Record record = Record::parse(text);
  CHECK(record.to_json() == text);
  CHECK(record.number("b") == 1);
  CHECK(std::isnan(record.number("c")));
  CHECK(record.at("c").text("d") == "x");
  CHECK(record.text("b").empty());
  CHECK(record.truth("e"));
  CHECK_FALSE(record.truth("b"));
  CHECK_FALSE(Record::parse("{\"b\":").is_object());
  CHECK(Record().to_json() == "null");
  CHECK(std::isnan(Record().number("b")));
}

TEST_CASE("the time to a goal is that from which on it stays reached, and the median that of a run") {
  const scene::ComparisonLimits limits;
  ComparedProblem problem = two_candidates();
  const Spread spread = time_to({1e-6}, problem, problem.candidates[0], limits);
  CHECK(spread.median == 4);
  CHECK(spread.least == 2);
  CHECK(spread.most == 6);
  CHECK(spread.repetition == 2);
  CHECK(time_to({}, problem, problem.candidates[0], limits).median == 4);  // the gradient tolerance, 1e-4
  MethodRun& run = problem.candidates[0].runs[0];
  run.trace.back().energy = 1.5;
  CHECK(seconds_to({1e-6}, problem, run, limits) == never);
  CHECK(milliseconds_per_iteration(problem.candidates[0]).assembly == 1000);
}

TEST_CASE("the status of most runs counts") {
  ComparedProblem problem = two_candidates();
  MethodCandidate& candidate = problem.candidates[0];
  candidate.runs[0].status = "crashed";
  candidate.runs[0].converged = false;
  CHECK(candidate.status() == "converged");
  CHECK(candidate.has_converged());
  candidate.runs[2].status = "crashed";
  CHECK(candidate.status() == "crashed");
  CHECK_FALSE(candidate.has_converged());
  CHECK(MethodCandidate{}.typical() == nullptr);
  CHECK(MethodCandidate{}.status() == "not_run");
}

TEST_CASE("verdicts name the first, by how much, and what is in doubt") {
  const scene::ComparisonLimits limits;
  ComparedProblem problem = two_candidates();
  const std::string second(problem.candidates[1].info.name);
  const std::vector<std::string> lines = verdicts(problem, limits);
  REQUIRE(lines.size() == 4);
  CHECK(lines[0] == "relative error 1e-03: " + second + " is first, after 2 s; " + default_method() +
                        " takes 4 s, 2.00 times as long");
  CHECK(reservations(problem, limits).empty());
  problem.polished = false;
  CHECK(reservations(problem, limits).size() == 1);
  problem.optimum = unknown;
  CHECK(reservations(problem, limits).size() == 1);
}

TEST_CASE("tables have a row a run and a row a method") {
  const MethodComparison comparison = comparison_of_two();
  CHECK(comparison.wanted_runs() == 6);
  CHECK(comparison.made_runs() == 6);
  const NumberTable runs(run_table(comparison)), methods(method_table(comparison));
  REQUIRE(runs.rows() == 6);
  REQUIRE(methods.rows() == 2);
  CHECK(runs.at(5, "seconds") == 4.5);
  CHECK(methods.at(1, "seconds_median") == 3);
  CHECK(methods.at(1, "seconds_to_1e-03_median") == 2);
  CHECK(Record::parse(comparison_json(comparison)).text("default") == default_method());
}

TEST_CASE("scenes say what is compared; what is wrong is named by its path") {
  const scene::Value scene = scene::parse_json(
      R"({"problems": [{"name": "one"}], "repetitions": 5, "limits": {"memory_limit": 100}})", "scene");
  CHECK_THROWS_WITH_AS(read_comparison_settings(scene),
                       doctest::Contains("limits.memory_limit: must be 0 (none) or at least 256"), Error);
  CHECK(problem_name(read_problem_list(scene).front()) == "one");
  CHECK_THROWS_WITH_AS(choose_methods({"nobody"}), doctest::Contains("there is no method 'nobody'"), Error);
  CHECK(choose_methods({"all"}).size() == baselines::methods().size());
  const scene::Value twice =
      scene::parse_json(R"({"problems": [{"name": "one"}, {"name": "one"}]})", "scene");
  CHECK_THROWS_WITH_AS(read_problem_list(twice), doctest::Contains("problems[1].name"), Error);
}
