// Locally injective mappings (Schueller, Kavan, Panozzo, Sorkine-Hornung 2013): from the rest pose, which has
// no inverted element, to the targets behind a barrier on det F that no step may cross. Their elastic term is
// open to choice; here it is that of the convex problem, so that results can be compared. Where we deviate:
// the weight of the targets is the problem's alpha and is not adapted, and the barrier's weight is lowered,
// each level minimised, until the barrier is worth a share of the energy below the tolerance.
#include "formulation.hpp"
#include "registry.hpp"

#include <isostretch/core/to_text.hpp>
#include <isostretch/energies/builtin/lim_barrier.hpp>

namespace isostretch::baselines {
namespace {

using Phase = Recorder::Phase;

constexpr double first_weight = 1, factor = 10, least_weight = 1e-12;
constexpr int iterations_per_level = 100'000;

Vector run(const Instance& instance, const Options& options, Recorder& recorder) {
  const sdp_penalty::Problem& problem = instance.problem;
  Vector x = with_hard_targets(problem, instance.rest);
  if (measure(problem, x).inverted > 0) {
    recorder.end(Status::not_applicable,
                 "with its hard targets in place the rest pose is not inversion-free");
    return {};
  }
  newton::Objective objective = elastic_objective(problem);
  auto& barrier =
      objective.add<newton::EnergyTerm>(weighted_elements(problem), energies::LimBarrier{.mu = 0});
  newton::Options newton;
  newton.scaled_gradient_tolerance = 0;
  newton.max_iterations = iterations_per_level;
  recorder.begin(Phase::solving);
  recorder.record(x);
  for (double weight = first_weight; weight >= least_weight && !recorder.ended(); weight /= factor) {
    barrier.set_scale(weight);
    newton.decrement_tolerance = 1e-2 * options.tolerance * recorder.last().energy;
    const newton::Summary summary = minimize(objective, x, newton, options, recorder);
    if (recorder.ended()) break;
    if (newton::failed(summary.status)) {
      recorder.end(Status::stalled, "barrier weight " + to_text(weight) + ": " + summary.message);
    } else if (barrier.value(x).value <= options.tolerance * recorder.last().energy) {
      recorder.end(Status::converged, "the barrier is worth less than the tolerance");
    }
  }
  recorder.end(Status::stalled, "the barrier's weight is at its least");
  return x;
}

}  // namespace

std::vector<Entry> locally_injective() {
  return {{{"locally_injective",
            "locally injective mappings",
            "Schueller et al. 2013",
            Kind::alternative,
            {},
            false},
           run}};
}

}  // namespace isostretch::baselines
