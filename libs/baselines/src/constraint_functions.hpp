#pragma once

#include <isostretch/sdp_penalty/problem.hpp>

#include <span>

namespace isostretch::baselines {

// S_i - margin I >= 0 as inequalities c(x) >= 0, for solvers of nonlinear programs.
enum class ConstraintForm {
  // All principal minors (Sylvester): 3 in 2D, 7 in 3D. The leading ones would do for definite matrices only.
  // Polynomials, not concave: nothing keeps a solver from ending elsewhere than at the optimum, and measures
  // tell.
  principal_minors,
  // 2D alone. Eigenvalues are not negative where S_11 + S_22 >= |(S_11 - S_22, 2 S_12)|, a second-order cone,
  // whose norm has no derivative at its tip: squared, and with S_11 + S_22 >= 0. (Measured: with a
  // smoothed norm instead Ipopt is quicker where few triangles are near the tip, and never ends where many
  // are.)
  second_order_cone
};

// The functions of all elements with their derivatives, dense for the unknowns of each element (corners.hpp).
// With a shift, S_i - (margin + t) I: t is one more unknown, the last of every element and of all.
class ConstraintFunctions {
 public:
  // The problem must outlive this.
  ConstraintFunctions(const sdp_penalty::Problem& problem, ConstraintForm form, bool with_shift = false);

  int per_element() const { return per_element_; }
  int count() const { return per_element_ * problem_.element_count(); }
  int columns() const { return columns_; }    // unknowns of an element
  int unknowns() const { return unknowns_; }  // of all
  bool with_shift() const { return with_shift_; }
  int unknown(int element, int column) const;

  // c, [element][function].
  void values(std::span<const double> x, std::span<double> c) const;
  // J, [element][function][column].
  void jacobian(std::span<const double> x, std::span<double> J) const;
  // block += sum of multipliers (one a function) times the element's Hessians; columns x columns.
  void add_hessian(int element, std::span<const double> x, std::span<const double> multipliers,
                   std::span<double> block) const;

 private:
  const sdp_penalty::Problem& problem_;
  ConstraintForm form_;
  bool with_shift_;
  int per_element_, columns_, unknowns_;
};

}  // namespace isostretch::baselines
