// Newton with the filters of the library newton: the default, the published one on its closed-form
// eigensystems, what came after it, and none.
#include "method_registry.hpp"
#include "newton_driver.hpp"

namespace isostretch::baselines {
namespace {

newton::Summary run_default(const DistortionProblem& problem, Vector& x, const MethodOptions& options,
                            const newton::IterationCallback& callback) {
  const Timer timer;
  newton::Objective objective = objective_of(problem);
  newton::Options own = shared_options(options);
  own.max_expansion = newton::Options().max_expansion;
  return minimize_since(timer, objective, x, own, callback);
}

template <newton::Projection projection>
newton::Summary run(const DistortionProblem& problem, Vector& x, const MethodOptions& options,
                    const newton::IterationCallback& callback) {
  const Timer timer;
  newton::Objective objective = objective_of(problem);
  newton::Options shared = shared_options(options);
  shared.projection = projection;
  return minimize_since(timer, objective, x, shared, callback);
}

}  // namespace

std::vector<Method> newton_methods() {
  using newton::Projection;
  return {
      {{"isostretch", "isostretch", "this library", Family::own}, nullptr, run_default},
      {{"analytic", "analytic eigensystems", "Smith, de Goes, Kim 2019", Family::own},
       nullptr,
       run<Projection::clamp>},
      {{"absolute", "absolute eigenvalues", "Chen et al. 2024", Family::newton},
       nullptr,
       run<Projection::abs>},
      {{"trust_region", "trust-region filtering", "Chen et al. 2024, second paper", Family::newton},
       nullptr,
       run<Projection::trust_region>},
      {{"progressive", "progressive filtering", "Fernandez-Fernandez et al. 2026", Family::newton},
       nullptr,
       run<Projection::progressive>},
      {{"newton", "unprojected Newton", "shifted where it is indefinite", Family::newton},
       nullptr,
       run<Projection::none>},
  };
}

}  // namespace isostretch::baselines
