#pragma once

#include <isostretch/newton/term.hpp>

#include <memory>
#include <utility>
#include <vector>

namespace isostretch::newton {

class MovingPattern;
class EqualityConstraints;

/// A sum of terms over the positions of nodes, some of which may be pinned hard: those keep the values that
/// the start of a solve gives them; others may be constrained, one coordinate of several nodes to each other.
/// Pins and equality constraints are eliminated from the linear systems.
///
/// The sparsity of the Hessian is that of the terms whose stencil stays, made once, and of those whose
/// stencil moves (Term::has_moving_stencil), made again after each move and merged with the first in a time
/// that is linear in its entries.
class Objective {
 public:
  /// Throws Error unless dim is 2 or 3 and there is a node, and no more of them than fit into an int with
  /// dim.
  Objective(int dim, int node_count);
  ~Objective();
  /// Takes over another objective.
  Objective(Objective&&) noexcept;
  /// Takes over another objective.
  Objective& operator=(Objective&&) noexcept;

  template <class T, class... Arguments>
  /// Adds a term of type T, made of the arguments, and returns it.
  T& add(Arguments&&... arguments) {
    auto term = std::make_unique<T>(std::forward<Arguments>(arguments)...);
    T& reference = *term;
    add_term(std::move(term));
    return reference;
  }
  /// Throws Error where the term says that it does not fit (Term::require_fits).
  void add_term(std::unique_ptr<Term> term);
  /// Takes a term out and destroys it. Throws Error when it is none of the objective's.
  void remove(const Term& term);
  /// Returns whether there is a term.
  bool has_terms() const { return !terms_.empty(); }

  /// Pins a node, or one coordinate of it. Throws Error when the node (or axis) is out of range.
  void pin(int node);
  /// Keeps one coordinate of a node where it is.
  void pin(int node, int axis);

  /// Makes the coordinate along `axis` the same for both nodes, in the start of a solve and ever after: nodes
  /// on a line across the axis. Ties add up; one pinned coordinate pins all that are constrained to it.
  /// Throws Error when a node or the axis is out of range.
  void add_equality(int node, int other, int axis);

  /// Returns the dimension, 2 or 3.
  int dim() const { return dim_; }
  /// Returns the number of nodes.
  int node_count() const { return node_count_; }
  /// Returns the number of coordinates of all nodes.
  int dofs() const { return dim_ * node_count_; }
  /// Returns whether a coordinate is pinned.
  bool has_pins() const;

  /// Returns the sparsity of the terms whose stencil stays, made at the first use after a change of terms or
  /// pins.
  const assembly::HessianPattern& pattern();

  /// Counts the terms, pins and equality constraints added: another number than before means another pattern.
  int version() const { return version_; }
  /// Counts the changes of stencils that move, as zero_matrix() and differentiate() have met them: another
  /// number than before means another pattern of zero_matrix(), of the same unknowns.
  int stencil_version() const { return stencil_version_; }

  /// Returns the sum over terms: +infinity, with the first offending element, as soon as one term says so.
  Evaluation value(const Vector& x);
  /// Returns whether a term gives exact changes (Term::has_exact_change).
  bool has_exact_changes() const;
  /// Returns the value of the terms that do not give exact changes: the part of the sum whose rounding blurs
  /// differences.
  Evaluation value_without_exact(const Vector& x);
  /// Returns the sum of the exact changes from x to x + t dx.
  double exact_change(const Vector& x, const Vector& dx, double t);
  /// Returns the value as value() does, and the gradient over all degrees of freedom (zero at pinned ones);
  /// with hessian, prepares hessian().
  Evaluation differentiate(const Vector& x, const projection::FilterOptions& filter, Vector& gradient,
                           bool hessian);
  /// Sets values to the Hessian of the last differentiate() over the unknowns: what is neither pinned nor
  /// constrained, and every set of constrained coordinates. `matrix` has the pattern of zero_matrix().
  void hessian(sparse::SymmetricMatrix& matrix);
  /// Returns an element to which a gradient or Hessian that is not finite can be traced, after
  /// differentiate(), and -1 if none of the terms knows of one.
  int element_not_finite() const;
  /// Returns the matrix with the sparsity of the sum and values 0.
  const sparse::SymmetricMatrix& zero_matrix();

  /// Tells all terms that a solve begins at x, or that a step has led there (Term::begin_solve, accepted).
  void begin_solve(const Vector& x);
  /// Tells all terms that a step has led to x.
  void accepted(const Vector& x);

  /// Takes a gradient to the unknowns.
  void restrict(const Vector& gradient, Vector& reduced);
  /// Takes a direction from the unknowns to all degrees of freedom (zero at pinned ones).
  void extend(const Vector& reduced, Vector& direction);
  /// Returns the axis of every unknown.
  std::vector<int> axes();
  /// Throws Error naming two nodes that are constrained but differ in x.
  void require_equalities(const Vector& x) const;

  /// Returns the largest t <= limit for which x + s dx is in every term's domain for all 0 <= s < t.
  double max_step(const Vector& x, const Vector& dx, double limit) const;
  /// Returns whether one of the terms has a barrier.
  bool has_barrier() const;

 private:
  void changed();
  void make_pattern();
  void follow_stencils();
  void tie_unknowns();
  const sparse::SymmetricMatrix& unreduced_matrix() const;
  void require_node(int node) const;
  int representative(int dof) const;

  int dim_;
  int node_count_;
  std::vector<std::unique_ptr<Term>> terms_;
  std::vector<bool> pinned_;
  std::vector<int>
      equal_to_;  ///< for every degree of freedom the next one of a chain to its representative; or empty
  std::unique_ptr<assembly::HessianPattern> pattern_;
  int version_ = 0;
  std::unique_ptr<MovingPattern> moving_;  ///< null without moving stencils
  int stencil_version_ = 0;
  std::unique_ptr<EqualityConstraints> equalities_;  ///< null without linear equality constraints
};

}  // namespace isostretch::newton
