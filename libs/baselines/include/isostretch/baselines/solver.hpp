#pragma once

#include <isostretch/baselines/instance.hpp>
#include <isostretch/baselines/result.hpp>
#include <isostretch/core/stop_token.hpp>

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace isostretch::baselines {

/// The limits of a run, besides the time, which is for the deadline of Options::stop to limit.
struct Limits {
  /// The largest memory of a process of the solver's own, in megabytes; 0: no limit.
  double megabytes = 0;
  int iterations = 0;  ///< in the solver's own count; 0: its own limit
};

/// How to run a solver.
struct Options {
  double tolerance = 1e-6;  ///< asked for, relative, in the terms of each solver's own stopping rule
  /// The limits of the run.
  Limits limits;
  /// Asked after every iterate, and some twenty times a second while a program runs. A request to stop ends
  /// the run with Status::callback, and the deadline, in wall-clock time, with Status::time_limit.
  StopToken stop;
  /// Where solvers that are programs exchange files; empty: the system's. Nothing is left there.
  std::filesystem::path temporary_folder;

  /// Throws Error naming the first option that makes no sense.
  void validate() const;
};

using isostretch::CallbackAction;
/// Called for every point of the trace.
using PointCallback = std::function<CallbackAction(const Point&, const Vector& x)>;

/// The kinds of problems that solvers solve.
enum class Kind {
  convex,      ///< the problem itself: all of these have the same optimum
  alternative  ///< another formulation of inversion-free manipulation, with another optimum or none
};

/// A solver that there is, and whether it can run here.
struct SolverInfo {
  std::string_view name;    ///< as on a command line
  std::string_view title;   ///< as in a table
  std::string_view source;  ///< paper or program
  /// The kind of problem that it solves.
  Kind kind = Kind::convex;
  /// The missing part without which it cannot run; empty where it can.
  std::string needs;
  bool bounds_stretch = false;  ///< knows Problem::largest_stretch; the others are not applicable for it
  /// Returns whether it can run here.
  bool available() const { return needs.empty(); }
};

/// Returns all that there are, ours first, in the order of a table. Programs are looked for in PATH each
/// time.
std::vector<SolverInfo> solvers();

/// Runs a solver on an instance. Throws Error for an unknown name (listing those there are), an invalid
/// instance or options; everything that happens to the solver itself is the Result's status.
Result solve(std::string_view solver, const Instance& instance, const Options& options = {},
             const PointCallback& callback = {});

}  // namespace isostretch::baselines
