// What goes on around the steps of every iterative method, and the line search that they share.
#include <isostretch/core/backtracking.hpp>
#include <isostretch/core/iteration_driver.hpp>

#include <doctest/doctest.h>

#include <limits>
#include <string>
#include <vector>

using namespace isostretch;

namespace {

enum class Status { not_run, done, stopped };

struct Row {
  int iteration = -1;
  double seconds = -1;
  int extra = 0;
};

struct Summary {
  Status status = Status::not_run;
  std::string message;
  int iterations = 0;
  std::vector<Row> trace;
};

using Driver = IterationDriver<Summary>;

}  // namespace

TEST_CASE("IterationDriver: rows get their number and their time, and the first reason to end stays") {
  Summary summary;
  Driver driver(summary, {}, {}, Status::stopped);
  CHECK_FALSE(driver.ended());
  for (int i = 0; i < 3; ++i, ++summary.iterations) CHECK(driver.record({.extra = 10 * i}, Vector()));
  REQUIRE(summary.trace.size() == 3);
  for (int i = 0; i < 3; ++i) {
    const Row& row = summary.trace[static_cast<std::size_t>(i)];
    CHECK(row.iteration == i);
    CHECK(row.extra == 10 * i);
    CHECK(row.seconds >= (i == 0 ? 0 : summary.trace[static_cast<std::size_t>(i) - 1].seconds));
  }
  CHECK(driver.seconds() >= summary.trace.back().seconds);
  CHECK_FALSE(driver.end(Status::done, "first"));
  CHECK_FALSE(driver.end(Status::stopped, "second"));
  CHECK(driver.ended());
  CHECK(summary.status == Status::done);
  CHECK(summary.message == "first");
  CHECK_FALSE(driver.record({}, Vector()));  // an end is not undone by one more row
  CHECK(summary.trace.size() == 4);
}

TEST_CASE("IterationDriver: the callback and the token end a solve, after the row is in the trace") {
  const Vector x = Vector::Ones(2);
  Summary summary;
  Driver driver(
      summary,
      [&](const Row& row, const Vector& at) {
        CHECK(at == x);
        return row.iteration == 1 ? CallbackAction::stop : CallbackAction::proceed;
      },
      {}, Status::stopped);
  CHECK(driver.record({}, x));
  ++summary.iterations;
  CHECK_FALSE(driver.record({}, x));
  CHECK(summary.trace.size() == 2);
  CHECK(summary.status == Status::stopped);
  CHECK(summary.message == "stopped by the callback");

  const StopSource source;
  Summary other;
  Driver asked(other, {}, source.token(), Status::stopped);
  CHECK(asked.record({}, x));
  source.request_stop();
  CHECK_FALSE(asked.record({}, x));
  CHECK(other.status == Status::stopped);
  CHECK(other.message == "interrupted");
}

TEST_CASE("IterationDriver: limits of iterations and of time, that of the token too") {
  Summary summary;
  const Driver driver(summary, {}, {}, Status::stopped);
  CHECK(driver.limit_reached(1) == SolveStatus::not_run);
  CHECK(driver.limit_reached(0) == SolveStatus::iteration_limit);
  summary.iterations = 1;
  CHECK(driver.limit_reached(1) == SolveStatus::iteration_limit);
  CHECK(driver.limit_reached(2, 1e-12) == SolveStatus::time_limit);
  CHECK(driver.limit_reached(2, 1e6) == SolveStatus::not_run);
  const Driver late(summary, {}, StopToken().with_time_limit(1e-12), Status::stopped);
  CHECK(late.limit_reached(2) == SolveStatus::time_limit);
  CHECK_FALSE(late.ended());  // the method says how it ends
}

TEST_CASE("backtrack: shortens until the step is accepted, given up, or out of tries") {
  const auto parabola = [](double t) { return -t + 2 * t * t; };  // falls up to 1/2
  const auto armijo = [](double step, double change) {
    return change <= -1e-4 * step ? Trial::accept : Trial::shorten;
  };
  const BacktrackedStep found = backtrack({1, 0.5, 60}, parabola, armijo);
  CHECK(found.accepted);
  CHECK(found.step == 0.25);
  CHECK(found.change == parabola(0.25));
  CHECK(found.evaluations == 3);

  const BacktrackedStep none = backtrack({1, 0.5, 2}, parabola, armijo);
  CHECK_FALSE(none.accepted);
  CHECK(none.step == 0.5);
  CHECK(none.evaluations == 2);

  const BacktrackedStep stopped =
      backtrack({3, 0.1, 60}, parabola, [](double, double) { return Trial::give_up; });
  CHECK_FALSE(stopped.accepted);
  CHECK(stopped.evaluations == 1);

  const auto wall = [](double t) { return t > 0.3 ? std::numeric_limits<double>::infinity() : -t; };
  CHECK(backtrack({1, 0.5, 60}, wall, armijo).step == 0.25);
  CHECK_FALSE(backtrack({1, 0.5, 0}, wall, armijo).accepted);
}
