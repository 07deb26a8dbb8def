#pragma once

#include <isostretch/core/stop_token.hpp>
#include <isostretch/projection/filter.hpp>
#include <isostretch/sparse/options.hpp>

#include <string>
#include <string_view>
#include <vector>

namespace isostretch::newton {

// How the Hessian is made positive definite.
enum class Projection {
  adaptive,  // filtered only as much as a step needs
  clamp,     // every negative eigenvalue at every quadrature point to zero
  abs,       // to its absolute value
  none,      // nothing; a failed factorization is answered by a diagonal shift
  // None, clamp or abs by how well the model fitted the last step (after Chen et al. 2024, "Trust-Region
  // Eigenvalue Filtering for Projected Newton"); clamp where none does not factorise.
  trust_region,
  // Clamp, but only at elements with a node at which the gradient exceeds a share of the largest one; the
  // share falls until the Hessian factorises (after Fernandez-Fernandez et al. 2026).
  progressive,
};

std::string_view projection_name(Projection projection) noexcept;
// Throws Error naming the choices.
Projection projection_from_name(std::string_view name);
std::vector<std::string> projection_names();

enum class LineSearch {
  backtracking,  // Armijo from the largest step that stays in the domain (at most 1)
  none,          // the full step, or the largest in the domain
};

struct Options {
  Projection projection = Projection::adaptive;
  // adaptive: steps before the exact Hessian is tried again after it failed to factorise or gave a poor step.
  int retry_interval = 3;
  // Smallest eigenvalue after filtering at a quadrature point, in the units of psi.
  double filter_threshold = 0;

  // Stopping. Each test is off when zero; the first that holds ends the solve.
  //   |gradient|_inf <= gradient_tolerance: absolute, as published comparisons use it (1e-4 with total rest
  //   area 1).
  double gradient_tolerance = 0;
  //   |gradient|_inf <= scaled_gradient_tolerance * median(diag Hessian) * diagonal of the bounding box of x:
  //   does not change with the units of length and energy. 1e-6 leaves positions accurate to a few digits
  //   more than that. The Newton decrement must besides be below 1e-8 of the energy, without which stiff
  //   elements among soft ones could pass for convergence.
  double scaled_gradient_tolerance = 1e-6;
  //   1/2 gradient . H^-1 gradient <= decrement_tolerance, in units of the energy: what a full step promises
  //   to gain.
  double decrement_tolerance = 0;
  //   (E_before - E) / |E| <= relative_energy_tolerance after a full step.
  double relative_energy_tolerance = 0;
  int max_iterations = 1000;
  double time_limit = 0;  // seconds
  /// Asked between iterations; the solve ends as with a callback, or with the limit of time, when it says so.
  StopToken stop;

  LineSearch line_search = LineSearch::backtracking;
  double armijo = 1e-4;  // share of the slope's promise that must be gained
  double backtracking_factor = 0.5;
  int max_backtracks = 60;
  double domain_fraction = 0.9;  // of the largest step in the domain, when that is shorter than 1

  // A first step that gains more than expansion_ratio times what the quadratic model promised is lengthened
  // by expansion_factor while the energy falls, up to max_expansion. max_expansion = 1 never lengthens.
  double expansion_ratio = 1.1;
  double expansion_factor = 2;
  double max_expansion = 64;

  // Added to the diagonal of every Hessian, relative to its median entry: an objective without pins is
  // singular along rigid motions. Multiplied by 100 as often as a fully filtered Hessian fails to factorise,
  // max_shifts times at most.
  double relative_shift = 1e-10;
  int max_shifts = 6;

  sparse::Options solver;

  // Iterative solvers need not be more accurate than the model is good: the relative residual asked of them
  // is at most largest_forcing, and falls with the square of the gradient (Eisenstat & Walker 1996, choice
  // 2), not below solver.pcg_tolerance. 0: always solver.pcg_tolerance.
  double largest_forcing = 0.1;

  // Throws Error naming the first option that makes no sense.
  void validate() const;
};

}  // namespace isostretch::newton
