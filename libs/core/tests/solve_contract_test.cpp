// The words that all solves share: errors with a kind, requests to stop, traces and times.
#include <isostretch/core/error.hpp>
#include <isostretch/core/phase_times.hpp>
#include <isostretch/core/solve_status.hpp>
#include <isostretch/core/stop_token.hpp>
#include <isostretch/core/text.hpp>
#include <isostretch/core/trace.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <set>
#include <string>

using namespace isostretch;

TEST_CASE("Error: the innermost kind stays, and what has none is input") {
  CHECK(Error("file:1: bad").kind() == ErrorKind::input);
  CHECK_FALSE(Error("file:1: bad").has_kind());
  const auto kind_of = [](const auto& work) {
    try {
      work();
    } catch (const Error& error) {
      return std::pair(error.kind(), std::string(error.what()));
    }
    return std::pair(ErrorKind::input, std::string("nothing thrown"));
  };
  const auto bad = [] { throw Error("bad"); };
  CHECK(kind_of([&] { with_error_kind(ErrorKind::misuse, bad); }) ==
        std::pair(ErrorKind::misuse, std::string("bad")));
  CHECK(kind_of([&] {
          with_error_kind(ErrorKind::resource, [&] { with_error_kind(ErrorKind::misuse, bad); });
        }).first == ErrorKind::misuse);
  CHECK(kind_of([&] { with_error_prefix("a.obj", bad); }).second == "a.obj: bad");
  CHECK(with_error_kind(ErrorKind::misuse, [] { return 3; }) == 3);
}

TEST_CASE("StopToken: a request reaches all copies, a deadline only those that were made with it") {
  CHECK_FALSE(StopToken().should_stop());
  CHECK(StopToken().seconds_left() == std::numeric_limits<double>::infinity());
  const StopSource source;
  const StopToken token = source.token(), late = token.with_time_limit(1e300),
                  past = token.with_time_limit(1e-12);
  while (!past.deadline_passed()) {
  }
  CHECK(past.should_stop());
  CHECK(past.seconds_left() == 0);
  CHECK_FALSE(past.stop_requested());
  CHECK_FALSE(late.should_stop());
  CHECK(late.seconds_left() > 1e8);
  CHECK(past.with_time_limit(100).deadline_passed());  // the earlier one counts
  CHECK(std::isinf(token.with_time_limit(0).seconds_left()));
  source.request_stop();
  CHECK(token.stop_requested());
  CHECK(late.should_stop());
}

TEST_CASE("Trace: tables grow by columns and rows, and their text reads back bit for bit") {
  Trace trace{{"iteration", "energy"}, {{0, 0.1}, {100000, std::nan("")}}};
  trace.add_column("chart", {7, 8});
  trace.add_front_column("frame", 2);
  CHECK(to_csv(trace) == "frame,iteration,energy,chart\n2,0,0.1,7\n2,100000,nan,8\n");
  CHECK(trace.column("energy") == 2);
  Trace all;
  all.append(trace);
  all.append(trace);
  CHECK(all.rows.size() == 4);
  CHECK_THROWS_WITH_AS(all.append(Trace{{"other"}, {}}), doctest::Contains("columns"), Error);
  CHECK_THROWS_WITH_AS(all.column("step"), "trace: there is no column 'step'", Error);
  CHECK_THROWS_WITH_AS(all.add_column("short", {1}), doctest::Contains("1 values of 'short' for 4 rows"),
                       Error);
}

TEST_CASE("PhaseTimes: phases keep their order and add up") {
  PhaseTimes times;
  times.add("read", 1);
  times.add("solve", 2);
  times.add("solve", 3);
  times.add("write", 4);
  REQUIRE(times.phases().size() == 3);
  CHECK(times.phases()[1] == std::pair(std::string("solve"), 5.0));
  CHECK(times.seconds("write") == 4);
  CHECK(times.seconds("never") == 0);
}

TEST_CASE("SolveStatus: every status has a name of its own") {
  std::set<std::string_view> names;
  for (int i = 0; i <= static_cast<int>(SolveStatus::failed); ++i)
    names.insert(solve_status_name(static_cast<SolveStatus>(i)));
  CHECK(names.size() == 1 + static_cast<std::size_t>(SolveStatus::failed));
}

TEST_CASE("text: counts, names and numbers to be read") {
  CHECK(counted(1, "chart") == "1 chart");
  CHECK(counted(1234567, "chart") == "1,234,567 charts");
  CHECK(with_thousands(-1234) == "-1,234");
  CHECK(in_words("stopped_by_callback") == "stopped by callback");
  CHECK(listed({"a", "b"}) == "a, b");
  CHECK(formatted("%d of %s", 3, "four") == "3 of four");
}
