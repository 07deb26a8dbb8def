// Our own solvers of the convex problem (library sdp_penalty), as rivals see them.
#include "registry.hpp"

#include <isostretch/sdp_penalty/solver.hpp>

namespace isostretch::baselines {
namespace {

using Phase = Recorder::Phase;
using sdp_penalty::Method;
using sdp_penalty::Penalty;

Status status_of(sdp_penalty::Status status) {
  switch (status) {
    case sdp_penalty::Status::optimal:
      return Status::converged;
    case sdp_penalty::Status::infeasible:
      return Status::claims_infeasible;
    case sdp_penalty::Status::path_end:
      return Status::stalled;
    case sdp_penalty::Status::iterations:
      return Status::iteration_limit;
    default:
      return Status::failed;
  }
}

Vector run(const Instance& instance, const Options& options, Recorder& recorder,
           sdp_penalty::Options method) {
  method.gap_tolerance = options.tolerance;
  if (options.limits.iterations > 0) method.max_iterations = options.limits.iterations;
  recorder.begin(Phase::solving);
  Vector x;
  const sdp_penalty::Summary summary = sdp_penalty::solve(
      instance.problem, x, method, [&](const sdp_penalty::Iteration& row, const Vector& iterate) {
        return recorder.record(iterate, row.iteration) ? sdp_penalty::CallbackAction::proceed
                                                       : sdp_penalty::CallbackAction::stop;
      });
  const bool no_memory = summary.message.find("out of memory") != std::string::npos;
  recorder.end(no_memory ? Status::memory_limit : status_of(summary.status), summary.message);
  recorder.result().iterations = summary.iterations;
  recorder.result().linear_solves = summary.linear_solves;
  recorder.result().lower_bound = summary.lower_bound;
  return x;
}

template <Method method>
Vector by_method(const Instance& instance, const Options& options, Recorder& recorder) {
  sdp_penalty::Options choice;
  choice.method = method;
  return run(instance, options, recorder, choice);
}

template <Penalty penalty, bool published>
Vector by_penalty(const Instance& instance, const Options& options, Recorder& recorder) {
  sdp_penalty::Options choice;
  choice.method = Method::penalty;
  choice.penalty.penalty = penalty;
  choice.penalty.as_published = published;
  return run(instance, options, recorder, choice);
}

}  // namespace

std::vector<Entry> own_methods() {
  constexpr std::string_view paper = "Liu, Gao, Zhu, Sifakis, Kavan 2016";
  return {
      {{"interior_point", "interior point", "isostretch: Nesterov-Todd, Mehrotra", Kind::convex, {}, true},
       by_method<Method::interior_point>},
      {{"penalty", "quadratic penalty", paper, Kind::convex, {}}, by_penalty<Penalty::quadratic, false>},
      {{"penalty_cubic", "cubic penalty", paper, Kind::convex, {}}, by_penalty<Penalty::cubic, false>},
      {{"penalty_spline", "spline penalty", paper, Kind::convex, {}}, by_penalty<Penalty::spline, false>},
      {{"penalty_published", "Algorithm 1 as published", paper, Kind::convex, {}},
       by_penalty<Penalty::quadratic, true>},
      {{"augmented_lagrangian",
        "augmented Lagrangian",
        "isostretch: Hestenes, Powell 1969",
        Kind::convex,
        {}},
       by_method<Method::augmented_lagrangian>},
      {{"spectral_sdp", "Spectral SDP", "Apkarian, Noll, Thevenet, Tuan 2004", Kind::convex, {}},
       by_method<Method::spectral_sdp>},
      {{"pennon", "PENNON", "Kocvara, Stingl 2003", Kind::convex, {}}, by_method<Method::pennon>},
  };
}

}  // namespace isostretch::baselines
