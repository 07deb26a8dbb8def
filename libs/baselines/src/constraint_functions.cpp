#include "constraint_functions.hpp"

#include "corners.hpp"

#include <isostretch/core/index.hpp>

#include <array>
#include <cstddef>

namespace isostretch::baselines {
namespace {

constexpr int most_entries = 6, most_functions = 7, most_columns = 13;

// Entries of a symmetric matrix: 00, 01, 11 or 00, 01, 02, 11, 12, 22.
using Entries = std::array<double, most_entries>;

// Functions of these, with derivatives. Not of all at once: the Hessian is that of a weighted sum.
struct Functions {
  std::array<double, most_functions> value{};
  std::array<Entries, most_functions> gradient{};
  std::array<Entries, most_entries> hessian{};

  void add_curvature(int i, int j, double value_ij) {
    hessian[at(i)][at(j)] += value_ij;
    if (i != j) hessian[at(j)][at(i)] += value_ij;
  }
};

// The minor k = s_ii s_jj - s_ij^2, from where the three stand in the entries.
void minor_of_two(const Entries& s, int k, int ii, int jj, int ij, double weight, Functions& f) {
  f.value[at(k)] = s[at(ii)] * s[at(jj)] - s[at(ij)] * s[at(ij)];
  f.gradient[at(k)][at(ii)] = s[at(jj)];
  f.gradient[at(k)][at(jj)] = s[at(ii)];
  f.gradient[at(k)][at(ij)] = -2 * s[at(ij)];
  f.add_curvature(ii, jj, weight);
  f.add_curvature(ij, ij, -2 * weight);
}

void minor_of_one(const Entries& s, int k, int ii, Functions& f) {
  f.value[at(k)] = s[at(ii)];
  f.gradient[at(k)][at(ii)] = 1;
}

void determinant_of_three(const Entries& s, int k, double weight, Functions& f) {
  const auto [a, b, c, d, e, g] = s;  // [a b c; . d e; . . g]
  f.value[at(k)] = a * (d * g - e * e) - b * (b * g - c * e) + c * (b * e - c * d);
  f.gradient[at(k)] = {d * g - e * e, 2 * (c * e - b * g), 2 * (b * e - c * d),
                       a * g - c * c, 2 * (b * c - a * e), a * d - b * b};
  f.add_curvature(0, 3, weight * g);
  f.add_curvature(0, 5, weight * d);
  f.add_curvature(3, 5, weight * a);
  f.add_curvature(0, 4, -2 * weight * e);
  f.add_curvature(3, 2, -2 * weight * c);
  f.add_curvature(5, 1, -2 * weight * b);
  f.add_curvature(1, 1, -2 * weight * g);
  f.add_curvature(2, 2, -2 * weight * d);
  f.add_curvature(4, 4, -2 * weight * a);
  f.add_curvature(1, 2, 2 * weight * e);
  f.add_curvature(1, 4, 2 * weight * c);
  f.add_curvature(2, 4, 2 * weight * b);
}

using Weights = std::array<double, most_functions>;

Functions principal_minors(int dim, const Entries& s, const Weights& weights) {
  Functions f;
  if (dim == 2) {
    minor_of_one(s, 0, 0, f);
    minor_of_one(s, 1, 2, f);
    minor_of_two(s, 2, 0, 2, 1, weights[2], f);
    return f;
  }
  minor_of_one(s, 0, 0, f);
  minor_of_one(s, 1, 3, f);
  minor_of_one(s, 2, 5, f);
  minor_of_two(s, 3, 0, 3, 1, weights[3], f);
  minor_of_two(s, 4, 0, 5, 2, weights[4], f);
  minor_of_two(s, 5, 3, 5, 4, weights[5], f);
  determinant_of_three(s, 6, weights[6], f);
  return f;
}

// (s_00 + s_11)^2 - |(s_00 - s_11, 2 s_01)|^2 is 4 times the determinant.
Functions second_order_cone(const Entries& s, const Weights& weights) {
  Functions f;
  f.value[0] = s[0] + s[2];
  f.gradient[0] = {1, 0, 1};
  minor_of_two(s, 1, 0, 2, 1, weights[1], f);
  return f;
}

// How the entries of an element's matrix depend on its unknowns, linearly.
class ElementMap {
 public:
  ElementMap(const sdp_penalty::Problem& problem, int element, bool with_shift)
      : corners_(problem, element), margin_(problem.margin), with_shift_(with_shift) {
    int entry = 0;
    for (int i = 0; i < corners_.dim; ++i)
      for (int j = i; j < corners_.dim; ++j, ++entry) {
        diagonal_[at(entry)] = i == j;
        auto& row = coefficient_[at(entry)];
        for (int a = 0; a <= corners_.dim; ++a)
          for (int r = 0; r < corners_.dim; ++r)
            row[at(corners_.dim * a + r)] = corners_.constraint_coefficient(i, j, a, r);
        if (with_shift) row[at(corners_.dofs())] = i == j ? -1 : 0;
      }
    entries_ = entry;
  }

  int columns() const { return corners_.dofs() + with_shift_; }
  int entries() const { return entries_; }
  double coefficient(int entry, int column) const { return coefficient_[at(entry)][at(column)]; }

  Entries matrix(std::span<const double> x) const {
    Entries s{};
    for (int entry = 0; entry < entries_; ++entry) {
      for (int a = 0; a <= corners_.dim; ++a)
        for (int r = 0; r < corners_.dim; ++r)
          s[at(entry)] += coefficient(entry, corners_.dim * a + r) * x[at(corners_.dof(a, r))];
      if (diagonal_[at(entry)]) s[at(entry)] -= margin_ + (with_shift_ ? x.back() : 0.0);
    }
    return s;
  }

 private:
  Corners corners_;
  double margin_;
  bool with_shift_;
  int entries_ = 0;
  std::array<bool, most_entries> diagonal_{};
  std::array<std::array<double, most_columns>, most_entries> coefficient_{};
};

Functions evaluate(const sdp_penalty::Problem& problem, ConstraintForm form, const Entries& s,
                   const Weights& weights = {}) {
  return form == ConstraintForm::principal_minors ? principal_minors(problem.dim(), s, weights)
                                                  : second_order_cone(s, weights);
}

int functions_of(ConstraintForm form, int dim) {
  if (form == ConstraintForm::second_order_cone) return 2;
  return dim == 2 ? 3 : 7;
}

}  // namespace

ConstraintFunctions::ConstraintFunctions(const sdp_penalty::Problem& problem, ConstraintForm form,
                                         bool with_shift)
    : problem_(problem),
      form_(form),
      with_shift_(with_shift),
      per_element_(functions_of(form, problem.dim())),
      columns_(problem.dim() * (problem.dim() + 1) + with_shift),
      unknowns_(problem.dim() * problem.node_count() + with_shift) {}

int ConstraintFunctions::unknown(int element, int column) const {
  const Corners corners(problem_, element);
  if (column == corners.dofs()) return unknowns_ - 1;
  return corners.dof(column / corners.dim, column % corners.dim);
}

void ConstraintFunctions::values(std::span<const double> x, std::span<double> c) const {
  for (int e = 0; e < problem_.element_count(); ++e) {
    const Functions f = evaluate(problem_, form_, ElementMap(problem_, e, with_shift_).matrix(x));
    for (int k = 0; k < per_element_; ++k) c[at(e * per_element_ + k)] = f.value[at(k)];
  }
}

void ConstraintFunctions::jacobian(std::span<const double> x, std::span<double> J) const {
  std::size_t place = 0;
  for (int e = 0; e < problem_.element_count(); ++e) {
    const ElementMap map(problem_, e, with_shift_);
    const Functions f = evaluate(problem_, form_, map.matrix(x));
    for (int k = 0; k < per_element_; ++k)
      for (int column = 0; column < columns_; ++column) {
        double sum = 0;
        for (int entry = 0; entry < map.entries(); ++entry)
          sum += f.gradient[at(k)][at(entry)] * map.coefficient(entry, column);
        J[place++] = sum;
      }
  }
}

void ConstraintFunctions::add_hessian(int element, std::span<const double> x,
                                      std::span<const double> multipliers, std::span<double> block) const {
  const ElementMap map(problem_, element, with_shift_);
  Weights weights{};
  for (int k = 0; k < per_element_; ++k) weights[at(k)] = multipliers[at(k)];
  const Functions f = evaluate(problem_, form_, map.matrix(x), weights);
  for (int j = 0; j < columns_; ++j) {
    Entries image{};  // of column j under the Hessian over the entries
    for (int m = 0; m < map.entries(); ++m)
      for (int n = 0; n < map.entries(); ++n) image[at(m)] += f.hessian[at(m)][at(n)] * map.coefficient(n, j);
    for (int i = 0; i < columns_; ++i)
      for (int m = 0; m < map.entries(); ++m)
        block[at(i * columns_ + j)] += map.coefficient(m, i) * image[at(m)];
  }
}

}  // namespace isostretch::baselines
