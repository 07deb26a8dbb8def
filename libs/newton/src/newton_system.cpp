#include "newton_system.hpp"

#include <algorithm>
#include <cmath>

namespace isostretch::newton {
namespace {

double median(std::vector<double> values) {
  if (values.empty()) return 0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace

// Iterative solvers are analyzed anew, so that a solve does not depend on those before it.
bool NewtonSystem::has_analysis() const {
  return linear_ && analyzed_version_ == objective_->version() &&
         linear_->statistics().backend != sparse::Backend::pcg;
}

void NewtonSystem::prepare(const Vector& x, const sparse::Options& options) {
  if (!has_analysis()) return analyze(x, options);
  update_coordinates(x);
  follow_stencils();
}

void NewtonSystem::analyze(const Vector& x, const sparse::Options& options) {
  analyzed_version_ = -1;
  matrix_ = objective_->zero_matrix();
  stencil_version_ = objective_->stencil_version();
  if (matrix_.size == 0) return;
  if (!linear_) linear_ = sparse::make_solver(options);
  axes_ = objective_->axes();
  update_coordinates(x);
  if (linear_->analyze(matrix_)) analyzed_version_ = objective_->version();
  ++analyses_;
}

// What goes wrong is said again by factorize().
void NewtonSystem::follow_stencils() {
  const sparse::SymmetricMatrix& zero = objective_->zero_matrix();
  if (stencil_version_ == objective_->stencil_version()) return;
  stencil_version_ = objective_->stencil_version();
  matrix_ = zero;
  if (matrix_.size > 0) linear_->update_pattern(matrix_);
}

bool NewtonSystem::assemble() {
  objective_->hessian(matrix_);
  if (!matrix_.is_finite()) return false;
  measure_stiffness();
  return true;
}

// Of at most a few thousand entries spread evenly.
void NewtonSystem::measure_stiffness() {
  constexpr int samples = 4096;
  const int stride = 1 + matrix_.size / samples;
  std::vector<double> diagonal;
  for (int j = 0; j < matrix_.size; j += stride) diagonal.push_back(std::abs(diagonal_entry(j)));
  typical_stiffness_ = median(std::move(diagonal));
}

double& NewtonSystem::diagonal_entry(int j) {
  return matrix_.value[static_cast<std::size_t>(matrix_.column_start[static_cast<std::size_t>(j)])];
}

void NewtonSystem::update_coordinates(const Vector& x) {
  linear_->set_coordinates(x.data(), objective_->dim(), objective_->node_count(), axes_);
}

sparse::FactorResult NewtonSystem::factorize(const Vector& x, double shift) {
  if (shift > 0)
    for (int j = 0; j < matrix_.size; ++j) diagonal_entry(j) += shift;
  update_coordinates(x);
  return linear_->factorize(matrix_);
}

sparse::SolveResult NewtonSystem::solve(const Vector& right, Vector& solution) {
  solution.resize(right.size());
  return linear_->solve_columns(right.data(), solution.data(), 1);
}

void NewtonSystem::drop_solver() {
  if (handed_in_) return;
  linear_.reset();
  analyzed_version_ = -1;
}

}  // namespace isostretch::newton
