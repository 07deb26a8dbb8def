#pragma once

#include <isostretch/core/option_fields.hpp>
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
constexpr ChoiceNames<Projection, 6> choice_names(Projection) {
  return {{{"adaptive", Projection::adaptive},
           {"clamp", Projection::clamp},
           {"abs", Projection::abs},
           {"none", Projection::none},
           {"trust_region", Projection::trust_region},
           {"progressive", Projection::progressive}}};
}

std::string_view projection_name(Projection projection) noexcept;
// Throws Error naming the choices.
Projection projection_from_name(std::string_view name);
std::vector<std::string> projection_names();

enum class LineSearch {
  backtracking,  // Armijo from the largest step that stays in the domain (at most 1)
  none,          // the full step, or the largest in the domain
};
constexpr ChoiceNames<LineSearch, 2> choice_names(LineSearch) {
  return {{{"backtracking", LineSearch::backtracking}, {"none", LineSearch::none}}};
}

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

  /// Visits (Field, member) for each option, see core/option_fields.hpp.
  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit);

  /// Throws OptionError naming the first option that makes no sense.
  void validate() const;
};

template <class Self, class Visit>
void Options::fields(Self& self, Visit&& visit) {
  constexpr bool expert = true;
  visit(Field{"projection", "How the Hessian is made positive definite"}, self.projection);
  visit(Field{"retry_interval",
              "Steps before the projection adaptive tries the exact Hessian again, after it failed",
              at_least(0), "", expert},
        self.retry_interval);
  visit(Field{"filter_threshold", "Smallest eigenvalue after filtering, in the units of the energy density",
              at_least(0), "", expert},
        self.filter_threshold);
  visit(Field{"gradient_tolerance",
              "Stop where no component of the gradient is larger; 0: by the other tolerances", at_least(0)},
        self.gradient_tolerance);
  visit(
      Field{"scaled_gradient_tolerance",
            "Stop where no component of the gradient is larger than this share of the median diagonal entry "
            "of the Hessian times the diagonal of the bounding box; 0: off",
            at_least(0), "", expert},
      self.scaled_gradient_tolerance);
  visit(Field{"decrement_tolerance", "Stop where a full step promises to gain less energy; 0: off",
              at_least(0), "", expert},
        self.decrement_tolerance);
  visit(Field{"relative_energy_tolerance",
              "Stop where a full step gained less than this share of the energy; 0: off", at_least(0), "",
              expert},
        self.relative_energy_tolerance);
  visit(Field{"max_iterations", "Stop a solve after so many Newton iterations", at_least(0)},
        self.max_iterations);
  visit(Field{"time_limit", "Stop after so long; 0: no limit", at_least(0), "seconds"}, self.time_limit);
  visit(Field{"line_search",
              "How long a step is: by Armijo's rule, or always the longest that is allowed",
              {},
              "",
              expert},
        self.line_search);
  visit(Field{"armijo", "Share of the gain that the slope promises which a step must reach", inside(0, 0.5),
              "", expert},
        self.armijo);
  visit(Field{"backtracking_factor", "What a step that gained too little is multiplied with", inside(0, 1),
              "", expert},
        self.backtracking_factor);
  visit(
      Field{"max_backtracks", "Steps tried in one direction before it is given up", at_least(1), "", expert},
      self.max_backtracks);
  visit(Field{"domain_fraction", "Share of the way to the first inverted element that a step may go",
              inside(0, 1), "", expert},
        self.domain_fraction);
  visit(Field{"expansion_ratio", "Gain over promise above which a first step is lengthened", at_least(0), "",
              expert},
        self.expansion_ratio);
  visit(Field{"expansion_factor", "What such a step is multiplied with", above(1), "", expert},
        self.expansion_factor);
  visit(Field{"max_expansion", "Let steps that gain more than promised grow up to this factor; 1: never",
              between(1, 1e6)},
        self.max_expansion);
  visit(Field{"relative_shift", "Added to the diagonal of the Hessian, as a share of its median entry",
              finite(at_least(0)), "", expert},
        self.relative_shift);
  visit(Field{"max_shifts", "How often that shift grows a hundredfold where the Hessian does not factorise",
              at_least(0), "", expert},
        self.max_shifts);
  visit(Field{"largest_forcing",
              "How inexact (relative residual) the first steps of iterative solvers may be; 0: always exact",
              below_highest(between(0, 1))},
        self.largest_forcing);
  visit(Field{"linear_solver", "Solver of the linear systems"}, self.solver);
}

}  // namespace isostretch::newton
