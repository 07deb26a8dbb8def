#include "slim.hpp"

#include "applicability.hpp"
#include "method_registry.hpp"
#include "newton_driver.hpp"

#include <isostretch/linalg/decompositions.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

namespace isostretch::baselines {
namespace {

// (d psi / d sigma_i) / (sigma_i - t), t the nearest stretch that costs nothing: 1, where the quotient has
// the curvature as its limit. Of the scale-invariant energies t moves with sigma, and the quotient is written
// out: t^2 is the product of the stretches for MIPS, the mean of their squares for conformal AMIPS.
template <int Dim>
double slope_over_distance(const energies::AnyEnergy& energy,
                           const invariants::PrincipalStretches<Dim, double>& s, int i, double slope,
                           double curvature) {
  constexpr double meeting = 1e-8;
  if (energy.name() == "mips_2d") {
    const double other = s.others(i), root = std::sqrt(s[i]);
    return (s[i] + other) * (root + std::sqrt(other)) / (s[i] * s[i] * other * root);
  }
  if (energy.name() == "conformal_amips_3d") {
    const double free = std::sqrt(s.I2() / Dim), scale = std::cbrt(s.J());
    return 2.0 / 3 * (s[i] + free) / (s[i] * scale * scale);
  }
  const double distance = s[i] - 1;
  return std::abs(distance) > meeting ? slope / distance : curvature;
}

// A few elements at one quadrature point of each: singular vectors and values, and what psi does there.
template <int Dim>
struct Batch {
  static constexpr int size = 64;
  static constexpr int pairs = invariants::pair_count<Dim>;
  using Matrix = Eigen::Matrix<double, Dim, Dim>;

  void set(int i, const Matrix& Fi) {
    for (int e = 0; e < Dim * Dim; ++e) F[index(e, i)] = Fi.data()[e];
  }
  void evaluate(const energies::AnyEnergy& energy) {
    linalg::signed_svd(Dim, linalg::SvdBatch{F.data(), U.data(), sigma.data(), V.data(), size, size});
    energy.evaluate_derivatives(Dim, {size, size, sigma.data(), psi.data(), gradient.data(), twist.data(),
                                      flip.data(), diagonal.data(), coupling.data()});
  }

  Matrix left(int i) const {
    Matrix result;
    for (int e = 0; e < Dim * Dim; ++e) result.data()[e] = U[index(e, i)];
    return result;
  }
  // omega^2 by direction.
  Eigen::Matrix<double, Dim, 1> squared_weights(const energies::AnyEnergy& energy, int i) const {
    invariants::PrincipalStretches<Dim, double> s;
    for (int e = 0; e < Dim; ++e) s.sigma[e] = sigma[index(e, i)];
    Eigen::Matrix<double, Dim, 1> squared;
    for (int e = 0; e < Dim; ++e)
      squared[e] = 0.5 * slope_over_distance<Dim>(energy, s, e, gradient[index(e, i)], diagonal[index(e, i)]);
    return squared;
  }

 private:
  static std::size_t index(int entry, int i) { return static_cast<std::size_t>(entry * size + i); }

  std::array<double, Dim * Dim * size> F, U, V;
  std::array<double, Dim * size> sigma, gradient, diagonal;
  std::array<double, pairs * size> twist, flip, coupling;
  std::array<double, size> psi;
};

}  // namespace

void SlimTerm::model(const Vector& x) {
  elements().dim == 2 ? model_elements<2>(x) : model_elements<3>(x);
}

template <int Dim>
void SlimTerm::model_elements(const Vector& x) {
#pragma omp parallel for schedule(static)
  for (int first = 0; first < element_count(); first += Batch<Dim>::size) {
    const int count = std::min(Batch<Dim>::size, element_count() - first);
    Batch<Dim> batch;
    for (int p = 0; p < elements().points_per_element; ++p) {
      for (int i = 0; i < Batch<Dim>::size; ++i) {  // the last element again as padding
        const int element = element_at(first + std::min(i, count - 1));
        batch.set(i, deformation_gradient<Dim>(x, point(element, p)));
      }
      batch.evaluate(energy());
      for (int i = 0; i < count; ++i) {
        const std::size_t at = point(element_at(first + i), p);
        const Eigen::Matrix<double, Dim, Dim> U = batch.left(i);
        const Eigen::Matrix<double, Dim, Dim> W2 =
            2 * elements().weights[at] * U * batch.squared_weights(energy(), i).asDiagonal() * U.transpose();
        const auto g = rest_gradients<Dim>(at);
        for_each_block<Dim>(hessian_at(first + i), [&](int a, int b, auto block) {
          if (p == 0) block.setZero();
          block += g.col(a).dot(g.col(b)) * W2;
        });
      }
    }
  }
}

namespace {

// Energies whose stress has the sign of sigma - t in every direction: the others have no such weights.
std::string why_not_applicable(const DistortionProblem& problem) {
  return needs_energy(problem, {"arap", "symmetric_arap", "symmetric_dirichlet", "symmetric_gradient",
                                "mips_2d", "conformal_amips_3d"});
}

newton::Summary run(const DistortionProblem& problem, Vector& x, const MethodOptions& options,
                    const newton::IterationCallback& callback) {
  const Timer timer;
  return minimize_with(timer, std::make_unique<SlimTerm>(problem), problem, x, options, callback);
}

}  // namespace

std::vector<Method> slim() {
  return {{{"slim", "SLIM", "Rabinovich et al. 2017", Family::majorization}, why_not_applicable, run}};
}

}  // namespace isostretch::baselines
