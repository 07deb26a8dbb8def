#pragma once

#include <isostretch/newton/term.hpp>

#include <memory>
#include <utility>
#include <vector>

namespace isostretch::newton {

class TiedUnknowns;

// A sum of terms over the positions of nodes, some of which may be pinned hard: those keep the values that
// the start of a solve gives them; others may be tied, one coordinate of several nodes to each other. Pins
// and ties are eliminated from the linear systems.
class Objective {
 public:
  /// Throws Error unless dim is 2 or 3 and there is a node, and no more of them than fit into an int with
  /// dim.
  Objective(int dim, int node_count);
  ~Objective();
  Objective(Objective&&) noexcept;
  Objective& operator=(Objective&&) noexcept;

  template <class T, class... Arguments>
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
  bool has_terms() const { return !terms_.empty(); }

  // Throws Error when the node (or axis) is out of range.
  void pin(int node);
  void pin(int node, int axis);

  // The coordinate along `axis` is the same for both nodes, in the start of a solve and ever after: nodes on
  // a line across the axis. Ties add up; one pinned coordinate pins all that are tied to it. Throws Error
  // when a node or the axis is out of range.
  void tie(int node, int other, int axis);

  int dim() const { return dim_; }
  int node_count() const { return node_count_; }
  int dofs() const { return dim_ * node_count_; }
  bool has_pins() const;

  // The sparsity of the sum, made at the first use after a change of terms or pins.
  const assembly::HessianPattern& pattern();

  /// Counts the terms, pins and ties added: another number than before means another pattern.
  int version() const { return version_; }

  // Sums over terms. The value is +infinity, with the first offending element, as soon as one term says so.
  Evaluation value(const Vector& x);
  // Gradient over all degrees of freedom (zero at pinned ones).
  Evaluation differentiate(const Vector& x, const projection::FilterOptions& filter, Vector& gradient,
                           bool hessian);
  // Hessian of the last differentiate() over the unknowns: what is neither pinned nor tied, and every set of
  // tied coordinates. `matrix` has the pattern of zero_matrix().
  void hessian(sparse::SymmetricMatrix& matrix);
  /// Returns an element to which a gradient or Hessian that is not finite can be traced, after
  /// differentiate(), and -1 if none of the terms knows of one.
  int element_not_finite() const;
  const sparse::SymmetricMatrix& zero_matrix();

  /// Tells all terms that a solve begins at x, or that a step has led there (Term::begin_solve, accepted).
  void begin_solve(const Vector& x);
  void accepted(const Vector& x);

  // A gradient over the unknowns, and a direction over all degrees of freedom (zero at pinned ones).
  void restrict(const Vector& gradient, Vector& reduced);
  void extend(const Vector& reduced, Vector& direction);
  // Axis of every unknown.
  std::vector<int> axes();
  // Throws Error naming two nodes that are tied but differ in x.
  void require_tied(const Vector& x) const;

  double max_step(const Vector& x, const Vector& dx, double limit) const;
  // Whether one of the terms has a barrier.
  bool has_barrier() const;

 private:
  void changed();
  void require_node(int node) const;
  int representative(int dof) const;

  int dim_;
  int node_count_;
  std::vector<std::unique_ptr<Term>> terms_;
  std::vector<bool> pinned_;
  std::vector<int>
      tied_to_;  // of every degree of freedom, the next one of a chain to its representative; or empty
  std::unique_ptr<assembly::HessianPattern> pattern_;
  int version_ = 0;
  std::unique_ptr<TiedUnknowns> tied_;  // null without ties
};

}  // namespace isostretch::newton
