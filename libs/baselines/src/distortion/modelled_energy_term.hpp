#pragma once

#include <isostretch/assembly/deformation_operator.hpp>
#include <isostretch/baselines/distortion.hpp>
#include <isostretch/newton/term.hpp>

#include <Eigen/Core>

#include <cstddef>

namespace isostretch::baselines {

// The energy of a problem with Hessians of elements that a method makes by itself, from the exact ones or
// from nothing. All else is as newton::EnergyTerm has it.
class ModelledEnergyTerm : public newton::Term {
 public:
  // Keeps a reference to the problem.
  explicit ModelledEnergyTerm(const DistortionProblem& problem);

  void require_fits(int dim, int node_count) const override {
    newton::require_fitting("an energy term", assembler_.dim(), assembler_.node_count(), dim, node_count);
  }
  int element_not_finite() const override { return assembler_.element_not_finite(); }
  void add_stencil(assembly::PatternBuilder& builder) const override { assembler_.add_stencil(builder); }
  void set_pattern(const assembly::HessianPattern& pattern) override { assembler_.set_pattern(pattern); }
  newton::Evaluation value(const Vector& x) override { return assembler_.value(x.data()); }
  newton::Evaluation differentiate(const Vector& x, const projection::FilterOptions& filter, Vector& gradient,
                                   bool hessian) override;
  void add_hessian(double* values) const override { assembler_.add_hessian(values); }
  double max_step(const Vector& x, const Vector& dx, double limit) const override {
    return assembler_.max_step(x.data(), dx.data(), limit);
  }
  bool has_barrier() const override { return assembler_.energy().has_barrier(); }

 protected:
  // Whether model() finds the exact Hessians of elements in its place, to change them.
  virtual bool wants_exact() const { return false; }
  // Writes the Hessian of every element, at positions where the energy is finite.
  virtual void model(const Vector& x) = 0;

  const assembly::Elements& elements() const { return problem_.elements; }
  const energies::AnyEnergy& energy() const { return problem_.energy; }
  int nodes() const { return elements().nodes_per_element; }
  int element_count() const { return elements().element_count(); }

  // The element in a place of the assembler's order, and its Hessian: blocks a <= b of nodes, row by row.
  int element_at(int place) const { return assembler_.element_order()[static_cast<std::size_t>(place)]; }
  double* hessian_at(int place) {
    return hessians_ + static_cast<std::size_t>(place) * assembler_.hessian_entries_per_element();
  }

  // Of a quadrature point of an element: its number among all points, rest gradients (node after node), and
  // F.
  std::size_t point(int element, int p) const {
    return static_cast<std::size_t>(element) * static_cast<std::size_t>(elements().points_per_element) +
           static_cast<std::size_t>(p);
  }
  template <int Dim>
  Eigen::Map<const Eigen::Matrix<double, Dim, Eigen::Dynamic>> rest_gradients(std::size_t point) const {
    return {elements().gradients.data() + point * static_cast<std::size_t>(nodes() * Dim), Dim, nodes()};
  }
  template <int Dim>
  Eigen::Matrix<double, Dim, Dim> deformation_gradient(const Vector& x, std::size_t point) const {
    const linalg::Mat<Dim> F = assembly::DeformationOperator<Dim>(elements()).apply(point, x.data());
    return Eigen::Map<const Eigen::Matrix<double, Dim, Dim, Eigen::RowMajor>>(F.m[0]);
  }

  // Calls body(a, b, block) for every block a <= b of an element's Hessian.
  template <int Dim, class Body>
  void for_each_block(double* hessian, const Body& body) const {
    using Block = Eigen::Map<Eigen::Matrix<double, Dim, Dim, Eigen::RowMajor>>;
    for (int a = 0; a < nodes(); ++a)
      for (int b = a; b < nodes(); ++b, hessian += Dim * Dim) body(a, b, Block(hessian));
  }

 private:
  const DistortionProblem& problem_;
  assembly::EnergyAssembler assembler_;
  double* hessians_ = nullptr;
};

}  // namespace isostretch::baselines
