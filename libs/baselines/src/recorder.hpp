#pragma once

#include <isostretch/baselines/solver.hpp>
#include <isostretch/core/timer.hpp>

#include <string>

namespace isostretch::baselines {

// The clock, the trace and the end of a run: what every solver reports to. Time spent on measures and in the
// callback is nobody's.
class Recorder {
 public:
  Recorder(const Instance& instance, const Options& options, const PointCallback& callback);

  // Phases follow one another; the first is modelling.
  enum class Phase { modelling, solving, reading };
  void begin(Phase phase);

  // The next iterate. False: stop, for a limit is reached or the callback said so.
  bool record(const Vector& x);
  // For solvers whose iterations have numbers of their own.
  bool record(const Vector& x, int iteration);
  // Between iterates. False: as above.
  bool may_go_on();

  int points() const { return static_cast<int>(result_.trace.size()); }
  int iterations() const { return result_.iterations; }  // as the solver has reported them so far
  // Of the last iterate; there must be one.
  const Measures& last() const { return result_.trace.back().measures; }
  // From here on an iterate without inverted elements ends the run as converged.
  void stop_without_inversions() { stops_without_inversions_ = true; }

  bool ended() const { return result_.status != Status::not_run; }
  // The first reason stays.
  void end(Status status, std::string message);

  // What the solver alone knows: iterations, linear_solves, lower_bound, peak_megabytes. finish() fills in
  // the rest.
  Result& result() { return result_; }
  Result finish(const Vector& x);

 private:
  void book_time();

  const Instance& instance_;
  const Options& options_;
  const PointCallback& callback_;
  Result result_;
  Timer timer_;  // since the last entry in the books
  double* phase_ = nullptr;
  bool stops_without_inversions_ = false;
};

}  // namespace isostretch::baselines
