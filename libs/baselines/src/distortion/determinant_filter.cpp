#include "determinant_filter.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace isostretch::baselines {
namespace {

constexpr int sweeps = 20;
constexpr double damping = 0.5;
constexpr double settled = 1e-3;  // relative change of the residual

template <int Dim>
using Matrix = Eigen::Matrix<double, Dim, Dim, Eigen::DontAlign>;

// d det F / dF.
Matrix<2> cofactor(const Matrix<2>& F) {
  Matrix<2> C;
  C << F(1, 1), -F(1, 0), -F(0, 1), F(0, 0);
  return C;
}

Matrix<3> cofactor(const Matrix<3>& F) {
  Matrix<3> C;
  for (int c = 0; c < 3; ++c)
    for (int r = 0; r < 3; ++r) {
      const int i = (r + 1) % 3, j = (r + 2) % 3, k = (c + 1) % 3, l = (c + 2) % 3;
      C(r, c) = F(i, k) * F(j, l) - F(i, l) * F(j, k);
    }
  return C;
}

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
  const std::size_t count = static_cast<std::size_t>(elements_.nodes_per_element);
  using Coordinates = Eigen::Map<const Eigen::Matrix<double, Dim, 1>>;
#pragma omp parallel for schedule(static)
  for (std::size_t t = 0; t < determinants_.size(); ++t) {
    const int* nodes = nodes_of(t);
    const double* gradients = elements_.gradients.data() + t * count * Dim;
    Matrix<Dim> F = Matrix<Dim>::Zero();
    for (std::size_t a = 0; a < count; ++a)
      F += Coordinates(x.data() + Dim * nodes[a]) * Coordinates(gradients + a * Dim).transpose();
    const Matrix<Dim> C = cofactor(F);
    determinants_[t] = F.col(0).dot(C.col(0)) - bound_;
    Eigen::Map<Eigen::Matrix<double, Dim, Eigen::Dynamic>> row(rows_.data() + t * count * Dim, Dim,
                                                               elements_.nodes_per_element);
    for (std::size_t a = 0; a < count; ++a) {
      const auto column = static_cast<Eigen::Index>(a);
      if (pinned_[static_cast<std::size_t>(nodes[a])])
        row.col(column).setZero();
      else
        row.col(column) = C * Coordinates(gradients + a * Dim);
    }
    squared_lengths_[t] = row.squaredNorm();
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
