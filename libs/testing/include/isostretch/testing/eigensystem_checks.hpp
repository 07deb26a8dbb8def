#pragma once

// The analytic eigensystem of an isotropic energy at one F, put together as dense matrices, so that it can be
// compared with any other Hessian and with a numerical eigen-decomposition. Clear rather than fast: the
// projection library is the fast one.

#include <isostretch/invariants/eigensystem.hpp>
#include <isostretch/linalg/decompositions.hpp>

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <vector>

namespace isostretch::testing {

/// An eigenvalue of the energy Hessian with its eigenvector.
template <int Dim>
struct Eigenpair {
  double value;                                ///< The eigenvalue.
  Eigen::Matrix<double, Dim * Dim, 1> vector;  ///< The eigenvector, a vec'ed matrix of norm 1.
};

/// Returns the analytic eigenpairs of the energy Hessian: twist_i and flip_i on the modes of F, and the Dim
/// eigenpairs of the scaling block A.
template <int Dim>
std::vector<Eigenpair<Dim>> analytic_eigenpairs(const invariants::Modes<Dim>& modes,
                                                const invariants::StretchDerivatives<Dim, double>& d) {
  std::vector<Eigenpair<Dim>> pairs;
  Eigen::Matrix<double, Dim, Dim> A = Eigen::Matrix<double, Dim, Dim>::Zero();
  for (int i = 0; i < Dim; ++i) A(i, i) = d.diagonal[i];
  for (int i = 0; i < d.pairs; ++i) {
    const int j = invariants::first<Dim>(i), k = invariants::second<Dim>(i);
    A(j, k) = A(k, j) = d.coupling[i];
    pairs.push_back({d.twist[i], modes.twist(i)});
    pairs.push_back({d.flip[i], modes.flip(i)});
  }
  const auto eigen = linalg::symmetric_eigen<Dim>(A);
  for (int n = 0; n < Dim; ++n) {
    Eigen::Matrix<double, Dim * Dim, 1> v = eigen.Q(0, n) * modes.scaling(0);
    for (int i = 1; i < Dim; ++i) v += eigen.Q(i, n) * modes.scaling(i);
    pairs.push_back({eigen.lambda[n], v});
  }
  return pairs;
}

/// Returns the sum of filter(value) vector vector^T.
template <int Dim, class Filter>
Eigen::Matrix<double, Dim * Dim, Dim * Dim> assemble(const std::vector<Eigenpair<Dim>>& pairs,
                                                     Filter filter) {
  Eigen::Matrix<double, Dim * Dim, Dim * Dim> H;
  H.setZero();
  for (const auto& pair : pairs) H += filter(pair.value) * pair.vector * pair.vector.transpose();
  return H;
}

/// Returns d psi / d vec(F) from the derivatives along the stretch.
template <int Dim>
Eigen::Matrix<double, Dim * Dim, 1> assemble_gradient(const invariants::Modes<Dim>& modes,
                                                      const invariants::StretchDerivatives<Dim, double>& d) {
  Eigen::Matrix<double, Dim * Dim, 1> g = d.gradient[0] * modes.scaling(0);
  for (int i = 1; i < Dim; ++i) g += d.gradient[i] * modes.scaling(i);
  return g;
}

/// A filter that keeps eigenvalues.
struct KeepEigenvalue {
  /// Returns the eigenvalue.
  double operator()(double value) const { return value; }
};
/// A filter that clamps eigenvalues at 0.
struct ClampEigenvalue {
  /// Returns max(value, 0).
  double operator()(double value) const { return std::max(value, 0.0); }
};
/// A filter that takes absolute values of eigenvalues.
struct AbsoluteEigenvalue {
  /// Returns |value|.
  double operator()(double value) const { return std::abs(value); }
};

/// Returns the filter applied to a numerical eigen-decomposition of H.
template <class Filter>
Eigen::MatrixXd filtered_numerically(const Eigen::MatrixXd& H, Filter filter) {
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(H);
  return eigen.eigenvectors() * eigen.eigenvalues().unaryExpr(filter).asDiagonal() *
         eigen.eigenvectors().transpose();
}

/// The differences between analytic eigenpairs and a Hessian that was computed otherwise, all relative to
/// |H|.
struct EigensystemErrors {
  double hessian = 0;      ///< |assembled - H|.
  double residual = 0;     ///< max |H v - lambda v|.
  double eigenvalues = 0;  ///< Largest difference of the sorted eigenvalues.
  double clamp = 0;        ///< Difference of the projections max(lambda, 0).
  double absolute = 0;     ///< Difference of the projections |lambda|.

  /// Returns the largest of the differences.
  double worst() const { return std::max({hessian, residual, eigenvalues, clamp, absolute}); }
};

/// Returns the differences between analytic eigenpairs and a Hessian, in every respect.
template <int Dim>
EigensystemErrors compare_eigensystem(const std::vector<Eigenpair<Dim>>& pairs,
                                      const Eigen::Matrix<double, Dim * Dim, Dim * Dim>& H) {
  const double scale = std::max(H.norm(), 1e-300);
  EigensystemErrors errors;
  Eigen::Matrix<double, Dim * Dim, 1> values;
  for (std::size_t n = 0; n < pairs.size(); ++n) {
    const auto& [value, vector] = pairs[n];
    values[static_cast<int>(n)] = value;
    errors.residual = std::max(errors.residual, (H * vector - value * vector).norm() / scale);
  }
  std::sort(values.begin(), values.end());
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(H, Eigen::EigenvaluesOnly);
  errors.eigenvalues = (values - eigen.eigenvalues()).cwiseAbs().maxCoeff() / scale;
  const auto difference = [&](auto filter) {
    return (assemble<Dim>(pairs, filter) - filtered_numerically(H, filter)).norm() / scale;
  };
  errors.hessian = (assemble<Dim>(pairs, KeepEigenvalue{}) - H).norm() / scale;
  errors.clamp = difference(ClampEigenvalue{});
  errors.absolute = difference(AbsoluteEigenvalue{});
  return errors;
}

}  // namespace isostretch::testing
