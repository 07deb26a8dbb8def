#include "deformation.hpp"

#include <isostretch/assembly/deformation_operator.hpp>
#include <isostretch/baselines/measures.hpp>
#include <isostretch/linalg/decompositions.hpp>
#include <isostretch/sdp_penalty/relinearize.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace isostretch::baselines {
namespace {

// NaN where one of them is.
double smaller(double a, double b) {
  return std::isnan(a) || a < b ? a : b;
}

// The largest singular value of every F.
std::vector<double> largest_stretches(const sdp_penalty::Problem& problem, const std::vector<double>& F) {
  const auto count = static_cast<std::size_t>(problem.element_count()),
             dim = static_cast<std::size_t>(problem.dim());
  std::vector<double> U(F.size()), sigma(count * dim), longest(count, 0.0);
  linalg::signed_svd(problem.dim(), {F.data(), U.data(), sigma.data(), nullptr, count, count});
  for (std::size_t k = 0; k < sigma.size(); ++k)
    longest[k % count] = std::max(longest[k % count], std::abs(sigma[k]));
  return longest;
}

void measure_constraint(const sdp_penalty::Problem& problem, const std::vector<double>& F,
                        Measures& measures) {
  const auto count = static_cast<std::size_t>(problem.element_count()),
             dim = static_cast<std::size_t>(problem.dim());
  const std::vector<double> S = constraint_matrices(problem, F);
  std::vector<double> lambda(count * dim);
  linalg::symmetric_eigen(problem.dim(), {S.data(), lambda.data(), nullptr, count, count});
  std::vector<double> longest;
  if (problem.bounds_stretch()) longest = largest_stretches(problem, F);
  measures.min_eigenvalue = std::numeric_limits<double>::infinity();
  measures.infeasible = 0;
  for (std::size_t e = 0; e < count; ++e) {
    double least = lambda[e];
    for (std::size_t k = 1; k < dim; ++k) least = smaller(least, lambda[k * count + e]);
    measures.min_eigenvalue = smaller(measures.min_eigenvalue, least);
    const bool too_long = !longest.empty() && !(longest[e] <= problem.largest_stretch);
    measures.infeasible += !(least >= problem.margin) || too_long;
  }
}

double distortion(const sdp_penalty::Problem& problem, const Vector& x, const std::vector<double>& F) {
  const std::vector<double> Q = sdp_penalty::nearest_rotations(problem.elements, x);
  const auto count = static_cast<std::size_t>(problem.element_count()),
             dim = static_cast<std::size_t>(problem.dim());
  double sum = 0;
  for (std::size_t e = 0; e < count; ++e)
    for (std::size_t r = 0; r < dim; ++r)
      for (std::size_t c = 0; c < dim; ++c) {
        const double difference = F[(r + dim * c) * count + e] - Q[(e * dim + c) * dim + r];
        sum += problem.weights[e] * difference * difference;
      }
  return sum;
}

}  // namespace

Measures measure(const sdp_penalty::Problem& problem, const Vector& x) {
  Measures measures;
  if (!x.allFinite()) {
    measures.infeasible = measures.inverted = problem.element_count();
    return measures;
  }
  measures.energy = sdp_penalty::energy(problem, x);
  measures.target_energy = sdp_penalty::target_energy(problem, x);
  const std::vector<double> F = deformation_gradients(problem.elements, x);
  measure_constraint(problem, F, measures);
  measures.distortion = distortion(problem, x, F);
  const std::vector<double> det = assembly::determinants(problem.elements, x.data());
  measures.min_determinant = *std::min_element(det.begin(), det.end());
  measures.inverted =
      static_cast<int>(std::count_if(det.begin(), det.end(), [](double d) { return !(d > 0); }));
  return measures;
}

}  // namespace isostretch::baselines
