#pragma once

#include <isostretch/assembly/block_assembler.hpp>
#include <isostretch/assembly/hessian_pattern.hpp>
#include <isostretch/assembly/restriction.hpp>
#include <isostretch/core/vector.hpp>
#include <isostretch/sdp_penalty/problem.hpp>
#include <isostretch/sparse/matrix.hpp>

#include <cstddef>
#include <vector>

namespace isostretch::sdp_penalty {

// Symmetric matrices of dim x dim, one an element, stored row by row with all entries.
using Blocks = std::vector<double>;

// Of positions, or of their multipliers: S_i = sym(R_i^T F_i), and B_i = [[b I, R_i^T F_i], [F_i^T R_i, b
// I]], of twice the size, where the problem bounds stretch.
struct Constrained {
  Blocks orientation, stretch;
};

// A spectral term's second derivative at every element: sum_jk h_jk (Q^T dS Q)_jk^2.
struct SpectralCurvature {
  Blocks Q;                           // a basis, vectors in columns
  std::vector<double> h;              // dim x dim an element, symmetric, not negative
  std::vector<unsigned char> active;  // 0: nothing here, Q and h are not looked at
};

// The linear algebra of a Problem: the quadratic objective f with Hessian H0, and the linear map A from
// positions to the matrices S_i = sym(R_i^T F_i). Positions have dim entries a node; matrices and the right
// sides that go with them are those of the unknowns that no hard target holds. Sums run in a fixed order, in
// parallel.
class System {
 public:
  explicit System(const Problem& problem);
  System(const System&) = delete;  // blocks_ refers to pattern_
  System& operator=(const System&) = delete;

  // Whether the problem has the nodes of these elements and these hard targets, so that set_problem() serves.
  bool has_structure_of(const Problem& problem) const;
  // Takes the values of another problem; it must outlive their use.
  void set_problem(const Problem& problem);

  const Problem& problem() const { return *problem_; }
  int dim() const { return dim_; }
  std::size_t blocks() const { return static_cast<std::size_t>(problem_->element_count()); }
  std::size_t block_size() const { return static_cast<std::size_t>(dim_ * dim_); }
  int unknowns() const { return pattern_.unknowns().size(); }

  // x with hard targets where they belong.
  Vector with_hard_targets(Vector x) const;
  // Hard targets where they belong, 0 elsewhere.
  Vector start() const { return with_hard_targets(Vector::Zero(pattern_.unknowns().dofs())); }
  // Entries of the unknowns, and back with 0 for what is held.
  Vector restrict_to_unknowns(const Vector& positions) const;
  Vector prolongate(const Vector& unknowns) const;

  // f(x + dx) - f(x) without cancellation, from the gradient at x.
  double change_of_objective(const Vector& gradient, const Vector& dx, double step) const;
  void gradient(const Vector& x, Vector& g) const;

  // S = A x.
  void constraints(const Vector& x, Blocks& S) const;
  // g += A^T M for symmetric M.
  void add_adjoint(const Blocks& M, Vector& g) const;

  // The same with what bounds stretch: at x, and its change along dx.
  Constrained constrained(const Vector& x) const;
  Constrained change_of_constrained(const Vector& dx) const;
  // g += the adjoint of M for B.
  void add_stretch_adjoint(const Blocks& M, Vector& g) const;
  // matrix += the form sum tr(W dB W dB).
  void add_stretch_weighted(const Blocks& W, sparse::SymmetricMatrix& matrix) const;

  // H0 itself, with the pattern of every matrix here.
  const sparse::SymmetricMatrix& quadratic() const { return quadratic_; }
  // matrix = H0 + A^T (W (x) W) A for symmetric W: the form sum tr(W dS W dS).
  void assemble_normal_equations(const Blocks& W, sparse::SymmetricMatrix& matrix);
  // matrix = H0 + A^T (curvature) A.
  void assemble_hessian(const SpectralCurvature& curvature, sparse::SymmetricMatrix& matrix) const;

  // det F of every element.
  std::vector<double> determinants(const Vector& x) const;

 private:
  // Writes P g_a to the entries of every corner a of element e, [element][corner][dim].
  template <int D>
  void store_forces(std::size_t e, const linalg::Mat<D>& P, std::vector<double>& corners) const;

  template <int D>
  void assemble_quadratic();
  template <int D>
  void weighted_blocks(const Blocks& W, sparse::SymmetricMatrix& matrix);
  Blocks stretch_blocks(const Vector& x, double diagonal) const;
  template <int D>
  void stretch_weighted_blocks(const Blocks& W, sparse::SymmetricMatrix& matrix) const;
  template <int D>
  void curved_blocks(const SpectralCurvature& curvature, sparse::SymmetricMatrix& matrix) const;

  const Problem* problem_;
  int dim_;
  // What the structure was made for.
  assembly::Restriction restriction_;
  std::vector<int> hard_nodes_;
  assembly::HessianPattern pattern_;
  assembly::BlockAssembler blocks_;
  sparse::SymmetricMatrix quadratic_;
  std::vector<double>
      image_;  // scratch of assemble_normal_equations(): R W R^T, then R W g_a for every corner
};

// g -= the adjoints of multipliers: the gradient of the Lagrangian from that of the objective.
void subtract_adjoint(const System& system, Constrained multipliers, Vector& g);

}  // namespace isostretch::sdp_penalty
