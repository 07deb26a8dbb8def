#pragma once

#include <isostretch/newton/term.hpp>

#include <memory>
#include <vector>

namespace isostretch::deformation {

/// Soft pins whose targets move between solves.
class SoftHandles final : public newton::Term {
 public:
  SoftHandles(int dim, int node_count, std::vector<newton::SoftPin> pins);

  /// The same pins in the same order, with other targets.
  void move(std::vector<newton::SoftPin> pins);

  void add_to(assembly::PatternBuilder& builder) const override { term_->add_to(builder); }
  void bind(const assembly::HessianPattern& pattern) override;
  newton::Evaluation value(const Vector& x) override { return term_->value(x); }
  newton::Evaluation differentiate(const Vector& x, const projection::FilterOptions& filter, Vector& gradient,
                                   bool hessian) override {
    return term_->differentiate(x, filter, gradient, hessian);
  }
  void add_hessian(double* values) const override { term_->add_hessian(values); }

 private:
  int dim_, node_count_;
  std::unique_ptr<newton::SoftPinTerm> term_;
  const assembly::HessianPattern* pattern_ = nullptr;
};

}  // namespace isostretch::deformation
