#pragma once

#include <isostretch/newton/term.hpp>

#include <memory>
#include <utility>
#include <vector>

namespace isostretch::newton {

// A sum of terms over the positions of nodes, some of which may be pinned hard: those keep the values that
// the start of a solve gives them, and are eliminated from the linear systems.
class Objective {
 public:
  Objective(int dim, int node_count);

  template <class T, class... Arguments>
  T& add(Arguments&&... arguments) {
    auto term = std::make_unique<T>(std::forward<Arguments>(arguments)...);
    T& reference = *term;
    add_term(std::move(term));
    return reference;
  }
  void add_term(std::unique_ptr<Term> term);

  // Throws Error when the node (or axis) is out of range.
  void pin(int node);
  void pin(int node, int axis);

  int dim() const { return dim_; }
  int node_count() const { return node_count_; }
  int dofs() const { return dim_ * node_count_; }
  bool has_pins() const;

  // The sparsity of the sum, made at the first use after a change of terms or pins.
  const assembly::HessianPattern& pattern();

  // Sums over terms. The value is +infinity, with the first offending element, as soon as one term says so.
  Evaluation value(const Vector& x);
  // Gradient over all degrees of freedom (zero at pinned ones).
  Evaluation differentiate(const Vector& x, const projection::FilterOptions& filter, Vector& gradient,
                           bool hessian);
  // Hessian of the last differentiate() over the free unknowns, into a matrix with this pattern.
  void hessian(sparse::SymmetricMatrix& matrix);
  double max_step(const Vector& x, const Vector& dx, double limit) const;

 private:
  void require_node(int node) const;

  int dim_;
  int node_count_;
  std::vector<std::unique_ptr<Term>> terms_;
  std::vector<bool> pinned_;
  std::unique_ptr<assembly::HessianPattern> pattern_;
};

}  // namespace isostretch::newton
