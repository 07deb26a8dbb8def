#include "objective.hpp"

#include "corners.hpp"

#include <isostretch/core/index.hpp>

#include <algorithm>
#include <cstddef>

namespace isostretch::baselines {
EnergyObjective::EnergyObjective(const sdp_penalty::Problem& problem)
    : problem_(problem), target_curvature_(at(problem.dim() * problem.node_count()), 0.0) {
  for (const sdp_penalty::Target& target : problem.targets)
    for (int r = 0; !target.hard && r < problem.dim(); ++r)
      target_curvature_[at(target.node * problem.dim() + r)] += 2 * problem.alpha;
}

double EnergyObjective::value(const Vector& x) const {
  return sdp_penalty::energy(problem_, x);
}

void EnergyObjective::gradient(const Vector& x, std::span<double> g) const {
  std::fill(g.begin(), g.end(), 0.0);
  add_elastic_gradient(x, g);
  const int dim = problem_.dim();
  for (const sdp_penalty::Target& target : problem_.targets)
    for (int r = 0; !target.hard && r < dim; ++r) {
      const int dof = target.node * dim + r;
      g[at(dof)] += 2 * problem_.alpha * (x[dof] - target.position[at(r)]);
    }
}

// dE/dF = 2 w (F - R) + kappa (tr(R^T F) - dim) R, and the gradient at corner a is that times g_a.
void EnergyObjective::add_elastic_gradient(const Vector& x, std::span<double> g) const {
  const int dim = problem_.dim();
  for (int e = 0; e < problem_.element_count(); ++e) {
    const Corners corners(problem_, e);
    double trace = -dim;
    for (int a = 0; a <= dim; ++a)
      for (int r = 0; r < dim; ++r) trace += corners.rotated_gradient(a, r) * x[corners.dof(a, r)];
    for (int r = 0; r < dim; ++r)
      for (int c = 0; c < dim; ++c) {
        double F = 0;
        for (int a = 0; a <= dim; ++a) F += x[corners.dof(a, r)] * corners.g(a, c);
        const double stress = 2 * problem_.weights[at(e)] * (F - corners.R(r, c)) +
                              problem_.incompressibility * trace * corners.R(r, c);
        for (int a = 0; a <= dim; ++a) g[at(corners.dof(a, r))] += stress * corners.g(a, c);
      }
  }
}

void EnergyObjective::add_hessian(int element, double factor, std::span<double> block, int columns) const {
  const Corners corners(problem_, element);
  const int dim = corners.dim;
  for (int a = 0; a <= dim; ++a)
    for (int b = 0; b <= dim; ++b) {
      double dot = 0;
      for (int c = 0; c < dim; ++c) dot += corners.g(a, c) * corners.g(b, c);
      for (int r = 0; r < dim; ++r) {
        const int row = (dim * a + r) * columns;
        block[at(row + dim * b + r)] += factor * 2 * problem_.weights[at(element)] * dot;
        for (int s = 0; s < dim; ++s)
          block[at(row + dim * b + s)] += factor * problem_.incompressibility *
                                          corners.rotated_gradient(a, r) * corners.rotated_gradient(b, s);
      }
    }
}

double EnergyObjective::hessian_diagonal(int dof) const {
  return target_curvature_[at(dof)];
}

}  // namespace isostretch::baselines
