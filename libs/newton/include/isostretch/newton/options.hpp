#pragma once

#include <isostretch/core/option_fields.hpp>
#include <isostretch/core/stop_token.hpp>
#include <isostretch/projection/filter.hpp>
#include <isostretch/sparse/options.hpp>

#include <string>
#include <string_view>
#include <vector>

namespace isostretch::newton {

/// The ways in which the Hessian is made positive definite.
enum class Projection {
  adaptive,  ///< Filters only as much as a step needs.
  clamp,     ///< Sets every negative eigenvalue at every quadrature point to zero.
  abs,       ///< Takes the absolute value of every eigenvalue.
  none,      ///< Filters nothing; a failed factorization is answered by a diagonal shift.
  /// Takes none, clamp or abs by how well the model fitted the last step (after Chen et al. 2024,
  /// "Trust-Region Eigenvalue Filtering for Projected Newton"), and clamp where none does not factorise.
  trust_region,
  /// Clamps, but only at elements with a node at which the gradient exceeds a share of the largest one; the
  /// share falls until the Hessian factorises (after Fernandez-Fernandez et al. 2026).
  progressive,
};
/// Returns the names of the projections on command lines and in scenes.
constexpr ChoiceNames<Projection, 6> choice_names(Projection) {
  return {{{"adaptive", Projection::adaptive},
           {"clamp", Projection::clamp},
           {"abs", Projection::abs},
           {"none", Projection::none},
           {"trust_region", Projection::trust_region},
           {"progressive", Projection::progressive}}};
}

/// Returns the name of a projection, such as "adaptive".
std::string_view projection_name(Projection projection) noexcept;
/// Returns the projection of that name. Throws Error naming the choices if there is none.
Projection projection_from_name(std::string_view name);
/// Returns the names of all projections.
std::vector<std::string> projection_names();

/// The ways in which the length of a step is found.
enum class LineSearch {
  backtracking,  ///< Armijo's rule from the largest step that stays in the domain, at most 1.
  none,          ///< The full step, or the largest in the domain.
};
/// Returns the names of the line searches in scenes.
constexpr ChoiceNames<LineSearch, 2> choice_names(LineSearch) {
  return {{{"backtracking", LineSearch::backtracking}, {"none", LineSearch::none}}};
}

/// The options of Newton's method. Of the tests of convergence each is off when it is zero; the first that
/// holds ends the solve.
struct Options {
  /// How the Hessian is made positive definite.
  Projection projection = Projection::adaptive;
  /// Steps before Projection::adaptive tries the exact Hessian again, after it failed to factorise or gave a
  /// poor step.
  int retry_interval = 3;
  /// Smallest eigenvalue after filtering at a quadrature point, in the units of psi.
  double filter_threshold = 0;

  /// Bound on |gradient|_inf at the end, absolute as published comparisons use it (1e-4 with total rest area
  /// 1).
  double gradient_tolerance = 0;
  /// Bound on |gradient|_inf at the end, over median(diag Hessian) times the diagonal of the bounding box of
  /// x. It does not change with the units of length and energy. 1e-6 leaves positions accurate to a few
  /// digits more than that. The Newton decrement must besides be below 1e-8 of the energy, without which
  /// stiff elements among soft ones could pass for convergence.
  double scaled_gradient_tolerance = 1e-6;
  /// Bound on 1/2 gradient . H^-1 gradient at the end, in units of the energy: the gain that a full step
  /// promises.
  double decrement_tolerance = 0;
  /// Bound on (E_before - E) / |E| after a full step.
  double relative_energy_tolerance = 0;
  /// Largest number of iterations.
  int max_iterations = 1000;
  /// Longest time of a solve, in seconds; 0: no limit.
  double time_limit = 0;
  /// Asked between iterations; the solve ends as with a callback, or with the limit of time, when it says so.
  StopToken stop;

  /// How the length of a step is found.
  LineSearch line_search = LineSearch::backtracking;
  /// Share of the gain which the slope promises that a step must reach.
  double armijo = 1e-4;
  /// Factor by which a step that gained too little is shortened.
  double backtracking_factor = 0.5;
  /// Largest number of steps tried in one direction.
  int max_backtracks = 60;
  /// Share of the largest step in the domain that is taken, when that is shorter than 1.
  double domain_fraction = 0.9;

  /// Gain over the gain that the quadratic model promised from which on a first step is lengthened while the
  /// energy falls.
  double expansion_ratio = 1.1;
  /// Factor by which such a step is lengthened.
  double expansion_factor = 2;
  /// Longest step that lengthening may lead to; 1 never lengthens.
  double max_expansion = 64;

  /// Share of the median entry that is added to the diagonal of every Hessian: an objective without pins is
  /// singular along rigid motions. It grows a hundredfold as often as a fully filtered Hessian fails to
  /// factorise.
  double relative_shift = 1e-10;
  /// Largest number of times that the shift grows.
  int max_shifts = 6;

  /// The solver of the linear systems.
  sparse::Options solver;

  /// Largest relative residual that is asked of iterative solvers, which need not be more accurate than the
  /// model is good. It falls with the square of the gradient (Eisenstat & Walker 1996, choice 2), not below
  /// solver.pcg_tolerance. 0: always solver.pcg_tolerance.
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
