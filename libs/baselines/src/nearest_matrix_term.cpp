#include "nearest_matrix_term.hpp"

#include <isostretch/sdp_penalty/element.hpp>

#include <cstddef>

namespace isostretch::baselines {

using linalg::Mat;

NearestMatrixTerm::NearestMatrixTerm(const sdp_penalty::Problem& problem)
    : problem_(problem), restriction_(problem.elements), matrices_(problem.rotations) {}

void NearestMatrixTerm::require_fits(int dim, int node_count) const {
  newton::require_fitting("a term of nearest matrices", problem_.dim(), problem_.node_count(), dim,
                          node_count);
}

void NearestMatrixTerm::add_stencil(assembly::PatternBuilder& builder) const {
  restriction_.add_stencil(builder);
}

void NearestMatrixTerm::set_pattern(const assembly::HessianPattern& pattern) {
  blocks_ = assembly::BlockAssembler(restriction_, pattern);
}

template <int D>
double NearestMatrixTerm::accumulate(const Vector& x, Vector* gradient) const {
  const auto deformation = sdp_penalty::deformation<D>(problem_);
  const double kappa = problem_.incompressibility;
  std::vector<double> corners(gradient ? restriction_.nodes().size() * D : 0);
  double sum = 0;
  for (std::size_t e = 0; e < problem_.weights.size(); ++e) {
    const Mat<D> R = sdp_penalty::rotation<D>(problem_, e), F = deformation.apply(e, x.data());
    Mat<D> P = linalg::from_columns<D>(matrices_.data() + e * D * D);
    P *= -1.0;
    P += F;
    const double trace = inner_product(R, F) - D, w = problem_.weights[e];
    sum += w * inner_product(P, P) + 0.5 * kappa * trace * trace;
    if (!gradient) continue;
    for (int r = 0; r < D; ++r)
      for (int c = 0; c < D; ++c) P[r][c] = 2 * w * P[r][c] + kappa * trace * R[r][c];
    double* out = corners.data() + e * (D + 1) * D;
    deformation.apply_transposed(e, P, [&](int a, int r, double value) { out[a * D + r] = value; });
  }
  if (gradient) restriction_.add_transposed(D, corners.data(), gradient->data());
  return sum;
}

newton::Evaluation NearestMatrixTerm::value(const Vector& x) {
  newton::Evaluation result;
  result.value = problem_.dim() == 2 ? accumulate<2>(x, nullptr) : accumulate<3>(x, nullptr);
  return result;
}

newton::Evaluation NearestMatrixTerm::differentiate(const Vector& x, const projection::FilterOptions&,
                                                    Vector& gradient, bool) {
  newton::Evaluation result;
  result.value = problem_.dim() == 2 ? accumulate<2>(x, &gradient) : accumulate<3>(x, &gradient);
  return result;
}

void NearestMatrixTerm::add_hessian(double* values) const {
  const auto add = [&]<int D>() {
    blocks_.add_computed<D, D + 1>(
        [&](std::size_t e, int a, int b, Mat<D>& sum) {
          sdp_penalty::add_elastic_block<D>(problem_, e, a, b, sum);
        },
        values);
  };
  problem_.dim() == 2 ? add.operator()<2>() : add.operator()<3>();
}

}  // namespace isostretch::baselines
