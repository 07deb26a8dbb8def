#include "certificate.hpp"

#include <isostretch/core/error.hpp>

namespace isostretch::sdp_penalty {

Unconstrained::Unconstrained(const System& system, const sparse::Options& options)
    : system_(system), solver_(sparse::make_solver(options)) {
  sparse::FactorResult result = solver_->analyze(system.quadratic());
  if (result) result = solver_->factorize(system.quadratic());
  if (!result)
    throw Error("inversion-free problem: without constraints it has no single solution (" + result.message +
                "): does every component have targets?");
}

Vector Unconstrained::solved(const Vector& right) const {
  Vector x(right.size());
  solver_->solve_columns(right.data(), x.data(), 1);
  return x;
}

Vector Unconstrained::minimiser() const {
  return solved(system_.linear());
}

double Unconstrained::lower_bound(const Vector& x, const std::vector<double>& S, const std::vector<double>& Y,
                                  double margin) const {
  double inner = 0;
  const int dim = system_.dim();
  const std::size_t entries = system_.block_size();
  std::vector<double> minus(Y.size());
  for (std::size_t k = 0; k < S.size(); ++k) {
    const std::size_t in_block = k % entries;
    const bool diagonal = in_block % static_cast<std::size_t>(dim + 1) == 0;
    inner += Y[k] * (S[k] - (diagonal ? margin : 0.0));
    minus[k] = -Y[k];
  }
  Vector r;
  system_.gradient(x, r);
  system_.add_adjoint(minus, r);
  return system_.objective(x) - inner - 0.5 * r.dot(solved(r));
}

}  // namespace isostretch::sdp_penalty
