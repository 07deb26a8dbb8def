// The sequence of convex problems with the rotations of the result before (Kovalsky, Aigerman, Basri, Lipman
// 2014), each solved by our interior point: library sdp_penalty has it.
#include "registry.hpp"

#include <isostretch/sdp_penalty/relinearize.hpp>

namespace isostretch::baselines {
namespace {

using Phase = Recorder::Phase;

Vector run(const Instance& instance, const Options& options, Recorder& recorder) {
  sdp_penalty::RelinearizeOptions rounds;
  rounds.solve.gap_tolerance = options.tolerance;
  rounds.tolerance = options.tolerance;
  if (options.limits.iterations > 0) rounds.max_rounds = options.limits.iterations;
  recorder.begin(Phase::solving);
  Vector x;
  const sdp_penalty::RelinearizeSummary summary = sdp_penalty::solve_relinearized(
      instance.problem, x, rounds, [&](const sdp_penalty::RelinearizeRound&, const Vector& iterate) {
        return recorder.record(iterate) ? sdp_penalty::CallbackAction::proceed
                                        : sdp_penalty::CallbackAction::stop;
      });
  Result& result = recorder.result();
  result.iterations = static_cast<int>(summary.rounds.size());
  result.linear_solves = 0;
  for (const sdp_penalty::RelinearizeRound& round : summary.rounds)
    result.linear_solves += round.linear_solves;
  if (summary.settled)
    recorder.end(Status::converged, "the rotations have settled");
  else if (summary.last.status == sdp_penalty::Status::infeasible)
    recorder.end(Status::claims_infeasible, summary.last.message);
  else if (!summary.last.feasible())
    recorder.end(Status::stalled, summary.last.message);
  else
    recorder.end(Status::iteration_limit, "the rotations have not settled");
  return x;
}

}  // namespace

std::vector<Entry> relinearized() {
  return {
      {{"relinearized", "re-linearised convex problems", "Kovalsky et al. 2014", Kind::alternative, {}, true},
       run}};
}

}  // namespace isostretch::baselines
