// Foldover-free maps (Garanzha, Kaporin, Kudryavtseva, Protais, Ray, Sokolov 2021), from the unconstrained
// minimiser with all targets held: library atlas has the method.
#include "formulation.hpp"
#include "registry.hpp"

#include <isostretch/parameterization/untangle.hpp>

namespace isostretch::baselines {
namespace {

using Phase = Recorder::Phase;

Vector run(const Instance& instance, const Options& options, Recorder& recorder) {
  const sdp_penalty::Problem& problem = instance.problem;
  recorder.begin(Phase::solving);
  Vector x = with_all_targets(problem, skinned(problem));
  if (!recorder.record(x)) return x;
  parameterization::UntangleOptions untangle;
  if (options.limits.iterations > 0) untangle.max_rounds = options.limits.iterations;
  const parameterization::UntangleResult result = parameterization::untangle(
      problem.elements, x, untangle, target_nodes(problem), [&](const auto&, const Vector& at) {
        return recorder.record(at) ? CallbackAction::proceed : CallbackAction::stop;
      });
  recorder.result().iterations = result.rounds;  // which the limit counts
  if (result.untangled)
    recorder.end(Status::converged, "no element is inverted");
  else if (result.rounds == untangle.max_rounds)
    recorder.end(Status::iteration_limit, "the rounds of regularisation are over");
  recorder.end(Status::stalled, "elements are inverted where it does not get any further");
  return x;
}

}  // namespace

std::vector<Entry> foldover_free() {
  return {
      {{"foldover_free", "foldover-free maps", "Garanzha et al. 2021", Kind::alternative, {}, false}, run}};
}

}  // namespace isostretch::baselines
