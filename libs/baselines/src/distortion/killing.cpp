#include "killing.hpp"

#include "applicability.hpp"
#include "method_registry.hpp"
#include "newton_driver.hpp"
#include "shear_modulus.hpp"

#include <Eigen/LU>

#include <memory>

namespace isostretch::baselines {

KillingTerm::KillingTerm(const DistortionProblem& problem)
    : ModelledEnergyTerm(problem), shear_(shear_at_rest(problem)) {}

void KillingTerm::model(const Vector& x) {
  elements().dim == 2 ? model_elements<2>(x) : model_elements<3>(x);
}

// u = sum of u_a N_a has the gradient sum u_a c_a^T, c_a = F^-T g_a, and
//   |grad u + grad u^T|^2 = 2 sum_ab (c_a . c_b)(u_a . u_b) + (c_a . u_b)(c_b . u_a).
template <int Dim>
void KillingTerm::model_elements(const Vector& x) {
#pragma omp parallel for schedule(static)
  for (int place = 0; place < element_count(); ++place) {
    const int element = element_at(place);
    for (int p = 0; p < elements().points_per_element; ++p) {
      const std::size_t at = point(element, p);
      const Eigen::Matrix<double, Dim, Dim> F = deformation_gradient<Dim>(x, at);
      const Eigen::Matrix<double, Dim, Dim> back = F.inverse().transpose();
      const double weight = shear_ * elements().weights[at] * F.determinant();
      const auto g = rest_gradients<Dim>(at);
      for_each_block<Dim>(hessian_at(place), [&](int a, int b, auto block) {
        if (p == 0) block.setZero();
        const Eigen::Matrix<double, Dim, 1> ca = back * g.col(a), cb = back * g.col(b);
        block += weight * cb * ca.transpose();
        block.diagonal().array() += weight * ca.dot(cb);
      });
    }
  }
}

namespace {

std::string why_not_applicable(const DistortionProblem& problem) {
  return needs_barrier(problem);
}

newton::Summary run(const DistortionProblem& problem, Vector& x, const MethodOptions& options,
                    const newton::IterationCallback& callback) {
  const Timer timer;
  return minimize_with(timer, std::make_unique<KillingTerm>(problem), problem, x, options, callback);
}

}  // namespace

std::vector<Method> killing() {
  return {{{"killing", "isometry-aware preconditioning", "Claici et al. 2017", Family::majorization},
           why_not_applicable,
           run}};
}

}  // namespace isostretch::baselines
