#include "dirichlet_metric.hpp"

#include <isostretch/assembly/operators.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

namespace isostretch::baselines {
namespace {

constexpr double relative_shift = 1e-10;

assembly::FreeUnknowns free_nodes(const DistortionProblem& problem) {
  std::vector<bool> pinned(static_cast<std::size_t>(problem.elements.node_count), false);
  for (const int node : problem.pinned) pinned[static_cast<std::size_t>(node)] = true;
  return assembly::FreeUnknowns(1, problem.elements.node_count, pinned);
}

double& diagonal(sparse::SymmetricMatrix& matrix, int unknown) {
  return matrix.value[static_cast<std::size_t>(matrix.column_start[static_cast<std::size_t>(unknown)])];
}

double median_diagonal(sparse::SymmetricMatrix& matrix) {
  std::vector<double> entries;
  for (int i = 0; i < matrix.size; ++i) entries.push_back(diagonal(matrix, i));
  const auto middle = entries.begin() + static_cast<std::ptrdiff_t>(entries.size() / 2);
  std::nth_element(entries.begin(), middle, entries.end());
  return *middle;
}

// One factor serves all iterations: it is worth more than the automatic choice allows, which has one
// iteration in mind.
sparse::Options always_direct() {
  sparse::Options options;
  options.automatic_max_flops = std::numeric_limits<double>::max();
  return options;
}

}  // namespace

DirichletMetric::DirichletMetric(const DistortionProblem& problem)
    : dim_(problem.elements.dim), dofs_(dim_ * problem.elements.node_count) {
  const assembly::FreeUnknowns free = free_nodes(problem);
  for (int i = 0; i < free.size(); ++i) nodes_.push_back(free.dof(i));
  if (nodes_.empty()) return;
  matrix_ = assembly::operators::laplacian(problem.elements, free);
  for (double& value : matrix_.value) value *= 2;
  shift_diagonal();
  solver_ = sparse::make_solver(always_direct());
  solver_->analyze(matrix_);
}

void DirichletMetric::shift_diagonal() {
  typical_stiffness_ = median_diagonal(matrix_);
  shift_ = relative_shift * typical_stiffness_;
  for (int i = 0; i < matrix_.size; ++i) diagonal(matrix_, i) += shift_;
}

void DirichletMetric::split(const Vector& x) {
  columns_.resize(unknowns());
  results_.resize(unknowns());
  for (int i = 0; i < matrix_.size; ++i)
    for (int axis = 0; axis < dim_; ++axis)
      columns_[axis * matrix_.size + i] = x[dim_ * nodes_[static_cast<std::size_t>(i)] + axis];
}

void DirichletMetric::join(Vector& x) const {
  x.setZero(dofs_);
  for (int i = 0; i < matrix_.size; ++i)
    for (int axis = 0; axis < dim_; ++axis)
      x[dim_ * nodes_[static_cast<std::size_t>(i)] + axis] = results_[axis * matrix_.size + i];
}

void DirichletMetric::solve(const Vector& right, Vector& direction) {
  split(right);
  solver_->solve_columns(columns_.data(), results_.data(), dim_);
  join(direction);
}

void DirichletMetric::product(const Vector& direction, Vector& result) {
  split(direction);
  for (int axis = 0; axis < dim_; ++axis)
    matrix_.multiply(columns_.data() + axis * matrix_.size, results_.data() + axis * matrix_.size);
  join(result);
}

void DirichletMetric::clear_unknowns(Vector& x) const {
  for (const int node : nodes_) x.segment(dim_ * node, dim_).setZero();
}

double DirichletMetric::norm() const {
  constexpr int most = 200;
  constexpr double accuracy = 1e-3;
  // Largest eigenvectors alternate between neighbours.
  Vector v(matrix_.size), product(matrix_.size);
  for (int i = 0; i < matrix_.size; ++i) v[i] = i % 2 == 0 ? 1 : -0.5;
  double norm = 0;
  for (int i = 0; i < most; ++i) {
    v.normalize();
    matrix_.multiply(v.data(), product.data());
    const double before = std::exchange(norm, product.norm());
    if (std::abs(norm - before) <= accuracy * norm) break;
    v.swap(product);
  }
  return norm;
}

}  // namespace isostretch::baselines
