#include "determinant_filter.hpp"

#include <isostretch/assembly/deformation_operator.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace isostretch::baselines {
namespace {

constexpr int sweeps = 20;
constexpr double damping = 0.5;
constexpr double settled = 1e-3;  // relative change of the residual

}  // namespace

DeterminantFilter::DeterminantFilter(const DistortionProblem& problem)
    : elements_(problem.elements),
      bound_(problem.energy.determinant_bound()),
      pinned_(static_cast<std::size_t>(elements_.node_count), false),
      determinants_(elements_.weights.size()),
      rows_(elements_.gradients.size()),
      squared_lengths_(elements_.weights.size()),
      constraints_(elements_.weights.size()),
      multipliers_(elements_.weights.size()) {
  for (const int node : problem.pinned) pinned_[static_cast<std::size_t>(node)] = true;
}

const int* DeterminantFilter::nodes_of(std::size_t point) const {
  const std::size_t element = point / static_cast<std::size_t>(elements_.points_per_element);
  return elements_.nodes.data() + element * static_cast<std::size_t>(elements_.nodes_per_element);
}

template <int Dim>
void DeterminantFilter::linearize(const Vector& x) {
  const auto entries = static_cast<std::size_t>(elements_.nodes_per_element * Dim);
  const assembly::DeformationOperator<Dim> deformation(elements_);
#pragma omp parallel for schedule(static)
  for (std::size_t t = 0; t < determinants_.size(); ++t) {
    const linalg::Mat<Dim> F = deformation.apply(t, x.data()), C = cofactor(F);
    determinants_[t] = -bound_;
    for (int r = 0; r < Dim; ++r) determinants_[t] += F[r][0] * C[r][0];
    const int* nodes = nodes_of(t);
    double* row = rows_.data() + t * entries;
    squared_lengths_[t] = 0;
    deformation.apply_transposed(t, C, [&](int a, int r, double value) {
      row[Dim * a + r] = pinned_[static_cast<std::size_t>(nodes[a])] ? 0.0 : value;
      squared_lengths_[t] += row[Dim * a + r] * row[Dim * a + r];
    });
  }
}

void DeterminantFilter::evaluate(const Vector& p) {
  const int dim = elements_.dim, count = elements_.nodes_per_element;
#pragma omp parallel for schedule(static)
  for (std::size_t t = 0; t < constraints_.size(); ++t) {
    const int* nodes = nodes_of(t);
    const double* row = rows_.data() + t * static_cast<std::size_t>(count * dim);
    double sum = determinants_[t];
    for (int a = 0; a < count; ++a)
      for (int r = 0; r < dim; ++r) sum += row[a * dim + r] * p[dim * nodes[a] + r];
    constraints_[t] = sum;
  }
}

double DeterminantFilter::sweep() {
  double residual = 0;
  for (std::size_t t = 0; t < constraints_.size(); ++t) {
    const double c = constraints_[t], m = multipliers_[t], scale = squared_lengths_[t];
    if ((m == 0 && c >= 0) || scale == 0) continue;
    const double incomplementary = m * scale + c - std::sqrt(m * scale * m * scale + c * c);
    residual += incomplementary * incomplementary;
    multipliers_[t] = std::max(m - damping * c / scale, 0.0);
  }
  return std::sqrt(residual);
}

void DeterminantFilter::add_multiples(Vector& p) const {
  const int dim = elements_.dim, count = elements_.nodes_per_element;
  for (std::size_t t = 0; t < multipliers_.size(); ++t) {
    if (multipliers_[t] == 0) continue;
    const int* nodes = nodes_of(t);
    const double* row = rows_.data() + t * static_cast<std::size_t>(count * dim);
    for (int a = 0; a < count; ++a)
      for (int r = 0; r < dim; ++r) p[dim * nodes[a] + r] += multipliers_[t] * row[a * dim + r];
  }
}

bool DeterminantFilter::apply(const Vector& x, Vector& p) {
  linearized(x, p);
  if (std::all_of(constraints_.begin(), constraints_.end(), [](double c) { return c >= 0; })) return false;
  std::fill(multipliers_.begin(), multipliers_.end(), 0.0);
  const Vector uncorrected = p;
  double residual = 0;
  for (int i = 0; i < sweeps; ++i) {
    const double before = residual;
    residual = sweep();
    p = uncorrected;
    add_multiples(p);
    evaluate(p);
    if (i > 0 && std::abs(before - residual) < settled * before) break;
  }
  return true;
}

std::vector<double> DeterminantFilter::linearized(const Vector& x, const Vector& p) {
  if (elements_.dim == 2)
    linearize<2>(x);
  else
    linearize<3>(x);
  evaluate(p);
  return constraints_;
}

}  // namespace isostretch::baselines
