#include <isostretch/assembly/least_parallel.hpp>
#include <isostretch/sdp_penalty/element.hpp>
#include <isostretch/sdp_penalty/problem.hpp>

#include <vector>

namespace isostretch::sdp_penalty {
namespace {

template <int D>
double elastic_energy(const Problem& problem, const Vector& x) {
  const auto count = static_cast<std::size_t>(problem.element_count());
  std::vector<double> values(count);
#pragma omp parallel for schedule(static) if (count > assembly::least_parallel)
  for (std::size_t e = 0; e < count; ++e) {
    linalg::Mat<D> G = unrotated<D>(problem, e, x);  // |F - R| = |R^T F - I|
    double trace = -D;
    for (int i = 0; i < D; ++i) {
      trace += G[i][i];
      G[i][i] -= 1;
    }
    values[e] = problem.weights[e] * inner_product(G, G) + 0.5 * problem.incompressibility * trace * trace;
  }
  double sum = 0;
  for (const double value : values) sum += value;
  return sum;
}

}  // namespace

double target_energy(const Problem& problem, const Vector& x) {
  const int dim = problem.dim();
  double sum = 0;
  for (const Target& target : problem.targets)
    for (int r = 0; !target.hard && r < dim; ++r) {
      const double distance = x[target.node * dim + r] - target.position[static_cast<std::size_t>(r)];
      sum += distance * distance;
    }
  return problem.alpha * sum;
}

double energy(const Problem& problem, const Vector& x) {
  return target_energy(problem, x) +
         (problem.dim() == 2 ? elastic_energy<2>(problem, x) : elastic_energy<3>(problem, x));
}

}  // namespace isostretch::sdp_penalty
