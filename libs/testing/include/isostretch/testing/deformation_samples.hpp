#pragma once

// Deformation gradients to try an energy on: generic ones and every degenerate kind that formulas trip over.

#include <isostretch/invariants/eigensystem.hpp>

#include <Eigen/Dense>

#include <random>
#include <string>
#include <vector>

namespace isostretch::testing {

/// A deformation gradient to try an energy on.
template <int Dim>
struct DeformationSample {
  std::string category;               ///< The kind of deformation, such as "rest".
  Eigen::Matrix<double, Dim, Dim> F;  ///< The deformation gradient.
  bool moderate;                      ///< Whether finite differences in double mean something here.
  bool smooth;                        ///< Whether all sigma_j + sigma_k > 0: the rotation is unique.
};

/// Returns a random rotation.
template <int Dim>
Eigen::Matrix<double, Dim, Dim> random_rotation(std::mt19937& generator) {
  std::normal_distribution<double> normal;
  Eigen::Matrix<double, Dim, Dim> Q;
  for (int e = 0; e < Dim * Dim; ++e) Q.data()[e] = normal(generator);
  // Gram and Schmidt, twice for columns that are nearly parallel: quick to compile.
  for (int j = 0; j < Dim; ++j) {
    for (int pass = 0; pass < 2; ++pass)
      for (int i = 0; i < j; ++i) Q.col(j) -= Q.col(i).dot(Q.col(j)) * Q.col(i);
    Q.col(j).normalize();
  }
  if (Q.determinant() < 0) Q.col(0) *= -1.0;
  return Q;
}

/// Returns U diag(sigma) V^T with random rotations.
template <int Dim>
Eigen::Matrix<double, Dim, Dim> with_stretch(const Eigen::Matrix<double, Dim, 1>& sigma,
                                             std::mt19937& generator) {
  const auto U = random_rotation<Dim>(generator), V = random_rotation<Dim>(generator);
  return U * sigma.asDiagonal() * V.transpose();
}

namespace detail {

template <int Dim>
Eigen::Matrix<double, Dim, 1> pick(double a, double b, double c) {
  if constexpr (Dim == 2) return {a, c};
  if constexpr (Dim == 3) return {a, b, c};
}

template <int Dim>
Eigen::Matrix<double, Dim, 1> random_stretch(double low, double high, std::mt19937& generator) {
  std::uniform_real_distribution<double> uniform(low, high);
  Eigen::Matrix<double, Dim, 1> sigma;
  for (int i = 0; i < Dim; ++i) sigma[i] = uniform(generator);
  return sigma;
}

}  // namespace detail

/// Returns deformation gradients to try an energy on: random_count generic ones and every degenerate kind
/// that formulas fail on.
template <int Dim>
std::vector<DeformationSample<Dim>> deformation_samples(int random_count = 8, unsigned seed = 1) {
  std::mt19937 generator(seed);
  std::vector<DeformationSample<Dim>> samples;
  using Sigma = Eigen::Matrix<double, Dim, 1>;
  const auto add = [&](const char* category, const Sigma& sigma, bool moderate, bool smooth = true) {
    samples.push_back({category, with_stretch<Dim>(sigma, generator), moderate, smooth});
  };
  using detail::pick;
  for (int i = 0; i < random_count; ++i) {
    add("random", detail::random_stretch<Dim>(0.5, 2.0, generator), true);
    Sigma inverted = detail::random_stretch<Dim>(0.5, 2.0, generator);
    inverted[Dim - 1] = -0.4 * inverted.minCoeff();
    add("inverted", inverted, true);
  }
  for (const double e : {1e-3, 1e-6, 1e-9})
    add("near rest", Sigma::Ones() + detail::random_stretch<Dim>(-e, e, generator), true);
  samples.push_back({"rest", Eigen::Matrix<double, Dim, Dim>::Identity(), true, true});
  add("rotation", Sigma::Ones(), true);
  add("repeated", Sigma::Constant(1.3), true);
  add("repeated", Sigma::Constant(0.6), true);
  add("repeated pair", pick<Dim>(1.5, 1.5, 0.75), true);
  add("repeated pair", pick<Dim>(1.5, 0.75, 0.75), true);
  add("graded", pick<Dim>(1e2, 1.0, 1e-2), false);
  add("graded", pick<Dim>(3e3, 2e3, 1e-2), false);
  add("zero", pick<Dim>(1.5, 0.75, 0.0), false);
  add("opposite", pick<Dim>(1.5, 0.75, Dim == 2 ? -1.5 : -0.75), false, false);
  add("rank one", pick<Dim>(1.5, 0.0, 0.0), false, Dim == 2);
  add("null", Sigma::Zero(), false, false);
  return samples;
}

}  // namespace isostretch::testing
