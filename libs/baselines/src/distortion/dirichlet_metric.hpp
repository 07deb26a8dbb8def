#pragma once

#include <isostretch/baselines/distortion.hpp>
#include <isostretch/sparse/solver.hpp>

#include <memory>
#include <vector>

namespace isostretch::baselines {

// The constant metric of first-order methods: H = Hessian of sum w |F|^2 over nodes that are not pinned, w
// the rest weights. That is what is left of ARAP's energy sum w |F - R|^2 when its rotations are held, hence
// a majorizer of it; and the same matrix A for every axis, twice the cotangent Laplacian, which alone is
// factorised.
//
// Without pins H is singular along translations, to which no gradient has a component: 1e-10 times the median
// of its diagonal is added to the diagonal, as newton::Options::relative_shift does. H means the shifted
// matrix from here on, so that product() and solve() are inverse to each other.
class DirichletMetric {
 public:
  // Pattern, values and symbolic factorization.
  explicit DirichletMetric(const DistortionProblem& problem);

  // Once, before the first solve().
  sparse::FactorResult factorize() { return solver_->factorize(matrix_); }

  // Degrees of freedom that are not pinned.
  int unknowns() const { return dim_ * matrix_.size; }

  // Over all degrees of freedom, zero at pinned ones: direction = H^-1 right, result = H direction.
  void solve(const Vector& right, Vector& direction);
  void product(const Vector& direction, Vector& result);

  // Entries of the unknowns to zero.
  void clear_unknowns(Vector& x) const;

  double shift() const { return shift_; }
  double typical_stiffness() const { return typical_stiffness_; }  // the median of the diagonal

  // |H|_2 by power iteration from a fixed start, until it changes by less than 1e-3 of it.
  double norm() const;

  // Null when everything is pinned.
  const sparse::Solver* solver() const { return solver_.get(); }

 private:
  void split(const Vector& x);  // to columns_, one an axis
  void join(Vector& x) const;   // from results_
  void shift_diagonal();

  int dim_;
  int dofs_;
  std::vector<int> nodes_;          // not pinned
  sparse::SymmetricMatrix matrix_;  // A
  std::unique_ptr<sparse::Solver> solver_;
  double shift_ = 0;
  double typical_stiffness_ = 0;
  Vector columns_, results_;
};

}  // namespace isostretch::baselines
