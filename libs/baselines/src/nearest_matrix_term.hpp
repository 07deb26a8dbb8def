#pragma once

#include <isostretch/assembly/block_assembler.hpp>
#include <isostretch/assembly/hessian_pattern.hpp>
#include <isostretch/assembly/restriction.hpp>
#include <isostretch/newton/term.hpp>
#include <isostretch/sdp_penalty/problem.hpp>

#include <vector>

namespace isostretch::baselines {

// sum w_i |F_i - M_i|^2 + kappa/2 sum (tr(R_i^T F_i) - dim)^2 with a matrix M_i for every element, at first
// its ex-rotation R_i: then this is the elastic energy of the convex problem. Quadratic; the problem must
// outlive it.
class NearestMatrixTerm final : public newton::Term {
 public:
  explicit NearestMatrixTerm(const sdp_penalty::Problem& problem);

  // [element][dim * dim] column by column.
  void set_matrices(std::vector<double> matrices) { matrices_ = std::move(matrices); }

  void require_fits(int dim, int node_count) const override;
  void add_stencil(assembly::PatternBuilder& builder) const override;
  void set_pattern(const assembly::HessianPattern& pattern) override;
  newton::Evaluation value(const Vector& x) override;
  newton::Evaluation differentiate(const Vector& x, const projection::FilterOptions& filter, Vector& gradient,
                                   bool hessian) override;
  void add_hessian(double* values) const override;

 private:
  template <int D>
  double accumulate(const Vector& x, Vector* gradient) const;

  const sdp_penalty::Problem& problem_;
  assembly::Restriction restriction_;
  assembly::BlockAssembler blocks_;
  std::vector<double> matrices_;
};

}  // namespace isostretch::baselines
