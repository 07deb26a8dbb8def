#pragma once

#include <isostretch/newton/term.hpp>

#include <memory>
#include <vector>

namespace isostretch::deformation {

/// A term of soft pins whose targets move between solves.
class SoftHandles final : public newton::Term {
 public:
  /// Makes the term of these pins.
  SoftHandles(int dim, int node_count, std::vector<newton::SoftPin> pins);

  /// Takes the same pins in the same order with other targets.
  void move(std::vector<newton::SoftPin> pins);

  /// Adds the pairs of nodes that the term couples.
  void add_stencil(assembly::PatternBuilder& builder) const override { term_->add_stencil(builder); }
  /// Prepares add_hessian() for a pattern, which must outlive this object.
  void set_pattern(const assembly::HessianPattern& pattern) override;
  /// Returns the energy of the pins at positions x.
  newton::Evaluation value(const Vector& x) override { return term_->value(x); }
  /// Returns the energy of the pins at positions x and adds its gradient; prepares the Hessian where that is
  /// asked for.
  newton::Evaluation differentiate(const Vector& x, const projection::FilterOptions& filter, Vector& gradient,
                                   bool hessian) override {
    return term_->differentiate(x, filter, gradient, hessian);
  }
  /// Adds the Hessian of the last differentiate() to the values of a matrix.
  void add_hessian(double* values) const override { term_->add_hessian(values); }

 private:
  int dim_, node_count_;
  std::unique_ptr<newton::SoftPinTerm> term_;
  const assembly::HessianPattern* pattern_ = nullptr;
};

}  // namespace isostretch::deformation
