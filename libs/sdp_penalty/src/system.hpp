#pragma once

#include <isostretch/assembly/hessian_pattern.hpp>
#include <isostretch/core/vector.hpp>
#include <isostretch/sdp_penalty/problem.hpp>
#include <isostretch/sparse/matrix.hpp>

#include <cstddef>
#include <vector>

namespace isostretch::sdp_penalty {

// The linear algebra of a Problem: quadratic objective 1/2 x^T H0 x - c^T x + constant, and the linear map A
// from positions to the symmetric matrices S_i = sym(R_i^T F_i), one dim x dim block a constraint, stored row
// by row with all entries.
class System {
 public:
  // Keeps a reference to the problem.
  explicit System(const Problem& problem);

  int dim() const { return dim_; }
  int unknowns() const { return problem_.dim() * problem_.node_count(); }
  std::size_t blocks() const { return static_cast<std::size_t>(problem_.element_count()); }
  std::size_t block_size() const { return static_cast<std::size_t>(dim_ * dim_); }

  double objective(const Vector& x) const;
  // Of the targets' term alone.
  double target_energy(const Vector& x) const;
  void gradient(const Vector& x, Vector& g) const;
  const Vector& linear() const { return linear_; }

  // S = A x.
  void constraints(const Vector& x, std::vector<double>& S) const;
  // g += A^T M for symmetric blocks M.
  void add_adjoint(const std::vector<double>& M, Vector& g) const;

  // H0 itself, with the pattern of every matrix here.
  const sparse::SymmetricMatrix& quadratic() const { return quadratic_; }
  // matrix = H0 + A^T (W (x) W) A for symmetric blocks W: the form sum tr(W dS W dS).
  void weighted(const std::vector<double>& W, sparse::SymmetricMatrix& matrix) const;

  // det F of every element.
  std::vector<double> determinants(const Vector& x) const;

 private:
  template <int Dim>
  void assemble_quadratic();
  template <int Dim>
  void element_weighted(const double* W, std::size_t e, double* slot) const;
  void scatter(std::size_t e, const double* slot, double* values) const;
  void index_entries();

  const Problem& problem_;
  int dim_, nodes_;
  std::size_t slot_size_;  // entries of an element: blocks a <= b of nodes, dim x dim each, row by row
  assembly::HessianPattern pattern_;
  sparse::SymmetricMatrix quadratic_;
  std::vector<int> entry_;  // [element][slot entry]: where in the values of a matrix; -1 above the diagonal
  Vector linear_;
  double constant_ = 0;
};

}  // namespace isostretch::sdp_penalty
