#include "dirichlet_metric.hpp"

#include <isostretch/energies/registry.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

namespace isostretch::baselines {
namespace {

constexpr double relative_shift = 1e-10;

// sum w |F|^2; the energy of that name has half of it.
newton::Objective dirichlet_objective(const DistortionProblem& problem) {
  newton::Objective objective(problem.elements.dim, problem.elements.node_count);
  objective.add<newton::EnergyTerm>(problem.elements, energies::make_energy("dirichlet")).set_scale(2);
  for (const int node : problem.pinned) objective.pin(node);
  return objective;
}

// Where all axes of a node are unknowns together, entries between equal axes of a matrix in which others are
// zero: those of the first axis.
sparse::SymmetricMatrix first_axis(const sparse::SymmetricMatrix& all, int dim) {
  sparse::SymmetricMatrix one;
  one.size = all.size / dim;
  one.column_start.push_back(0);
  for (std::size_t j = 0; j < static_cast<std::size_t>(all.size); j += static_cast<std::size_t>(dim)) {
    for (auto k = static_cast<std::size_t>(all.column_start[j]);
         k < static_cast<std::size_t>(all.column_start[j + 1]); ++k) {
      if (all.row[k] % dim != 0) continue;
      one.row.push_back(all.row[k] / dim);
      one.value.push_back(all.value[k]);
    }
    one.column_start.push_back(one.nonzeros());
  }
  return one;
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
  newton::Objective objective = dirichlet_objective(problem);
  const assembly::FreeUnknowns& unknowns = objective.pattern().unknowns();
  for (int i = 0; i < unknowns.size(); i += dim_) nodes_.push_back(unknowns.dof(i) / dim_);
  if (nodes_.empty()) return;
  fill(objective);
  shift_diagonal();
  solver_ = sparse::make_solver(always_direct());
  solver_->analyze(matrix_);
}

void DirichletMetric::fill(newton::Objective& objective) {
  projection::FilterOptions exact;
  exact.filter = projection::Filter::none;
  Vector gradient;
  const Vector anywhere = Vector::Zero(dofs_);  // the Hessian is the same everywhere
  objective.differentiate(anywhere, exact, gradient, true);
  sparse::SymmetricMatrix all = objective.zero_matrix();
  objective.hessian(all);
  matrix_ = first_axis(all, dim_);
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
