// L-BFGS about the Laplacian (Liu, Bouaziz, Kavan 2017): the metric, not scaled, is the initial matrix of
// every iteration. Backtracking from the full step, or 0.9 of the largest in the domain.
//
// Deviation: their initial matrix has the stiffness of the energy at rest for a factor, and theirs is a line
// search without a domain.
#include "method_registry.hpp"
#include "newton_driver.hpp"
#include "quasi_newton.hpp"

namespace isostretch::baselines {
namespace {

newton::Summary run(const DistortionProblem& problem, Vector& x, const MethodOptions& options,
                    const newton::IterationCallback& callback) {
  QuasiNewton method(shared_options(options));
  return minimize_first_order(method, problem, x, options, callback);
}

}  // namespace

std::vector<Method> lbfgs_methods() {
  return {{{"lbfgs", "L-BFGS about the Laplacian", "Liu, Bouaziz, Kavan 2017", Family::constant_metric},
           nullptr,
           run}};
}

}  // namespace isostretch::baselines
