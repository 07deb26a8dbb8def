#include "nearest_matrix_term.hpp"

#include <array>
#include <cstddef>

namespace isostretch::baselines {
namespace {

using Matrix = std::array<std::array<double, 3>, 3>;

}  // namespace

// One element's share of the arrays.
struct NearestMatrixTerm::Element {
  Element(const sdp_penalty::Problem& problem, std::size_t e)
      : dim(static_cast<std::size_t>(problem.dim())),
        nodes(problem.elements.nodes.data() + e * (dim + 1)),
        gradients(problem.elements.gradients.data() + e * (dim + 1) * dim),
        R(problem.rotations.data() + e * dim * dim) {}

  Matrix deformation_gradient(const Vector& x) const {
    Matrix F{};
    for (std::size_t a = 0; a <= dim; ++a)
      for (std::size_t r = 0; r < dim; ++r)
        for (std::size_t c = 0; c < dim; ++c) F[r][c] += x[dof(a, r)] * gradients[a * dim + c];
    return F;
  }
  Eigen::Index dof(std::size_t a, std::size_t r) const {
    return static_cast<Eigen::Index>(dim) * nodes[a] + static_cast<Eigen::Index>(r);
  }
  // Entry r of the gradient of tr(R^T F) by the position of corner a.
  double trace_gradient(std::size_t a, std::size_t r) const {
    double sum = 0;
    for (std::size_t c = 0; c < dim; ++c) sum += R[r + dim * c] * gradients[a * dim + c];
    return sum;
  }

  std::size_t dim;
  const int* nodes;
  const double *gradients, *R;
};

NearestMatrixTerm::NearestMatrixTerm(const sdp_penalty::Problem& problem)
    : problem_(problem), matrices_(problem.rotations) {}

void NearestMatrixTerm::require_fits(int dim, int node_count) const {
  newton::require_fitting("a term of nearest matrices", problem_.dim(), problem_.node_count(), dim,
                          node_count);
}

void NearestMatrixTerm::add_to(assembly::PatternBuilder& builder) const {
  const int corners = problem_.elements.nodes_per_element;
  for (int e = 0; e < problem_.element_count(); ++e)
    builder.add_clique(problem_.elements.nodes.data() + static_cast<std::ptrdiff_t>(e) * corners, corners);
}

double NearestMatrixTerm::accumulate(const Vector& x, Vector* gradient) const {
  double sum = 0;
  for (std::size_t e = 0; e < problem_.weights.size(); ++e) {
    const Element element(problem_, e);
    const std::size_t dim = element.dim;
    const double w = problem_.weights[e], *M = matrices_.data() + e * dim * dim;
    Matrix P = element.deformation_gradient(x);
    double trace = -static_cast<double>(dim);
    for (std::size_t r = 0; r < dim; ++r)
      for (std::size_t c = 0; c < dim; ++c) {
        trace += element.R[r + dim * c] * P[r][c];
        P[r][c] -= M[r + dim * c];
        sum += w * P[r][c] * P[r][c];
      }
    const double kappa = problem_.incompressibility;
    sum += 0.5 * kappa * trace * trace;
    if (!gradient) continue;
    for (std::size_t a = 0; a <= dim; ++a)
      for (std::size_t r = 0; r < dim; ++r) {
        double& entry = (*gradient)[element.dof(a, r)];
        entry += kappa * trace * element.trace_gradient(a, r);
        for (std::size_t c = 0; c < dim; ++c) entry += 2 * w * P[r][c] * element.gradients[a * dim + c];
      }
  }
  return sum;
}

newton::Evaluation NearestMatrixTerm::value(const Vector& x) {
  newton::Evaluation result;
  result.value = accumulate(x, nullptr);
  return result;
}

newton::Evaluation NearestMatrixTerm::differentiate(const Vector& x, const projection::FilterOptions&,
                                                    Vector& gradient, bool) {
  newton::Evaluation result;
  result.value = accumulate(x, &gradient);
  return result;
}

void NearestMatrixTerm::add_hessian(double* values) const {
  for (std::size_t e = 0; e < problem_.weights.size(); ++e) {
    const Element element(problem_, e);
    const std::size_t dim = element.dim;
    for (std::size_t a = 0; a <= dim; ++a)
      for (std::size_t b = 0; b <= dim; ++b) {
        if (element.nodes[a] < element.nodes[b]) continue;
        double dot = 0;
        for (std::size_t c = 0; c < dim; ++c)
          dot += element.gradients[a * dim + c] * element.gradients[b * dim + c];
        const int* positions = pattern_->positions(pattern_->block(element.nodes[a], element.nodes[b]));
        for (std::size_t r = 0; r < dim; ++r)
          for (std::size_t c = 0; c < dim; ++c) {
            const int position = positions[r * dim + c];
            if (position < 0) continue;
            values[position] +=
                (r == c ? 2 * problem_.weights[e] * dot : 0.0) +
                problem_.incompressibility * element.trace_gradient(a, r) * element.trace_gradient(b, c);
          }
      }
  }
}

}  // namespace isostretch::baselines
