#include "certificate.hpp"

#include <isostretch/core/error.hpp>

#include <cmath>
#include <limits>

namespace isostretch::sdp_penalty {

Unconstrained::Unconstrained(const sparse::Options& options) : solver_(sparse::make_solver(options)) {}

bool Unconstrained::refresh(const System& system) {
  const bool same_structure = system_ == &system;
  system_ = &system;
  if (same_structure && system.quadratic().value == factorised_) return false;
  if (system.unknowns() == 0) return false;
  factorised_.clear();
  sparse::FactorResult result;
  if (!same_structure) result = solver_->analyze(system.quadratic());
  if (result) result = solver_->factorize(system.quadratic());
  if (!result) {
    system_ = nullptr;
    throw Error("inversion-free problem: without constraints it cannot be solved (" + result.message + ")");
  }
  factorised_ = system.quadratic().value;
  return true;
}

// Of the unknowns; 0 at hard targets.
Vector Unconstrained::solved(const Vector& right) const {
  if (system_->unknowns() == 0) return Vector::Zero(right.size());
  const Vector b = system_->restrict_to_unknowns(right);
  Vector x(b.size());
  solver_->solve_columns(b.data(), x.data(), 1);
  return system_->prolongate(x);
}

Vector Unconstrained::minimiser() const {
  const Vector x = system_->start();
  Vector g;
  system_->gradient(x, g);
  return x - solved(g);
}

double Unconstrained::lower_bound(const Vector& gradient, double energy, const Constrained& at_x,
                                  const Constrained& multipliers) const {
  double inner = 0, size = std::abs(energy);  // of the terms, whose rounding the bound must survive
  const Blocks &S = at_x.orientation, &Y = multipliers.orientation;
  const double margin = system_->problem().margin;
  const std::size_t entries = system_->block_size(), diagonal = static_cast<std::size_t>(system_->dim() + 1);
  const auto add = [&](double term) {
    inner += term;
    size += std::abs(term);
  };
  for (std::size_t k = 0; k < S.size(); ++k) add(Y[k] * S[k]);
  for (std::size_t first = 0; first < S.size(); first += entries)
    for (std::size_t k = 0; k < entries; k += diagonal) inner -= Y[first + k] * margin;
  for (std::size_t k = 0; k < multipliers.stretch.size(); ++k) add(multipliers.stretch[k] * at_x.stretch[k]);
  Vector r = gradient;
  subtract_adjoint(*system_, multipliers, r);
  const double bound =
      energy - inner - 0.5 * r.dot(solved(r)) - std::numeric_limits<double>::epsilon() * size;
  return std::isfinite(bound) ? bound : -std::numeric_limits<double>::infinity();
}

}  // namespace isostretch::sdp_penalty
