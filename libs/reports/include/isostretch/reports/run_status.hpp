#pragma once

namespace isostretch::reports {

/// How the work of a program has ended, in the order of gravity.
enum class RunStatus {
  success,        ///< The result is what was asked for.
  not_converged,  ///< There is a usable result, which is not converged or misses a bound.
  failed          ///< A solver failed, or the result has inverted elements.
};

/// The facts of a run, besides its result, that summaries have.
struct RunFacts {
  int threads = 1;     ///< Threads of the parallel loops.
  double read = 0;     ///< Seconds from files to the problem.
  double initial = 0;  ///< Seconds of rest shape and start, of a parameterization.
  double solve = 0;    ///< Seconds of all frames, of a sequence.
  double write = 0;    ///< Seconds of results and pictures.
  double total = 0;    ///< Seconds since the work began, until the summary is composed.
};

}  // namespace isostretch::reports
