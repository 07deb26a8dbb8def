// The penalty on det F itself, which the spectral penalty of Liu et al. (2016) is compared with in their
// figure 12: tau sum w_i max(0, epsilon - det F_i)^2 beside the elastic energy, tau driven up. Not convex.
#include "formulation.hpp"
#include "registry.hpp"

#include <isostretch/energies/any_energy.hpp>

#include <algorithm>

namespace isostretch::baselines {
namespace {

using Phase = Recorder::Phase;

// What the determinants are kept above, and the path of penalty factors: as our penalty's.
constexpr double epsilon = 1e-6, first_tau = 1, last_tau = 1e12, factor = 10;
constexpr int iterations_per_level = 300;

struct DeterminantPenalty {
  static constexpr const char* name = "determinant_penalty";

  template <int Dim, class T>
  T psi(const invariants::Invariants<Dim, T>& I) const {
    using isostretch::invariants::select;
    const T below = epsilon - I.I3;
    return select(T(0.0) < below, below * below, T(0.0));
  }
};

Vector run(const Instance& instance, const Options& options, Recorder& recorder) {
  const sdp_penalty::Problem& problem = instance.problem;
  newton::Objective objective = elastic_objective(problem);
  auto& penalty = objective.add<newton::EnergyTerm>(weighted_elements(problem), DeterminantPenalty{});
  newton::Options newton;
  newton.scaled_gradient_tolerance = 0;
  newton.max_iterations = iterations_per_level;
  recorder.begin(Phase::solving);
  Vector x = skinned(problem);
  recorder.result().linear_solves = 1;
  recorder.record(x);
  for (double tau = first_tau; tau <= last_tau * 1.001 && !recorder.ended(); tau *= factor) {
    penalty.set_scale(tau);
    newton.decrement_tolerance = 1e-8 * recorder.last().energy;
    const newton::Summary summary = minimize(objective, x, newton, options, recorder);
    if (recorder.ended()) break;
    if (newton::failed(summary.status)) {
      recorder.end(Status::stalled, "penalty factor " + std::to_string(tau) + ": " + summary.message);
    } else if (recorder.last().inverted == 0) {
      recorder.end(Status::converged, "no element is inverted at the end of a level");
    }
  }
  recorder.end(Status::stalled, "elements are inverted at the last penalty factor");
  return x;
}

}  // namespace

std::vector<Entry> determinant_penalty() {
  return {{{"determinant_penalty",
            "penalty on det F",
            "Liu et al. 2016, figure 12",
            Kind::alternative,
            {},
            false},
           run}};
}

}  // namespace isostretch::baselines
