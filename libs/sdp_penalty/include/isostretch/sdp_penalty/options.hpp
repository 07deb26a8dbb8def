#pragma once

#include <isostretch/core/option_fields.hpp>
#include <isostretch/core/stop_token.hpp>
#include <isostretch/sparse/options.hpp>

#include <string_view>
#include <vector>

namespace isostretch::sdp_penalty {

/// The methods that solve the convex problem.
enum class Method {
  interior_point,        ///< The default: fewest factorizations, flat in resolution.
  augmented_lagrangian,  ///< Needs no large penalty factor, and starts from the result of the solve before.
  penalty,               ///< A path of penalty factors (Liu et al. 2016).
  spectral_sdp,          ///< Multipliers with a quadratic-logarithmic term (Apkarian et al. 2004).
  pennon,                ///< Multipliers with a reciprocal barrier (Kocvara, Stingl 2003).
  unconstrained  ///< The minimiser without constraints alone (tau = 0), which may have inverted elements.
};
/// Returns the names of the methods on command lines and in scenes.
constexpr ChoiceNames<Method, 6> choice_names(Method) {
  return {{{"interior_point", Method::interior_point},
           {"augmented_lagrangian", Method::augmented_lagrangian},
           {"penalty", Method::penalty},
           {"spectral_sdp", Method::spectral_sdp},
           {"pennon", Method::pennon},
           {"unconstrained", Method::unconstrained}}};
}

/// The penalties on negative eigenvalues of S - margin I, with y = lambda - epsilon (Liu et al. 2016, section
/// 4).
enum class Penalty {
  quadratic,  ///< tau y^2 for y < 0.
  cubic,      ///< -tau y^3 for y < 0, whose violation falls with the square root of tau only.
  /// -log(1 + tau y) / tau, continued by 2 tau y^2 - (log 1/2 + 1/2) / tau below tau y = -1/2, where value,
  /// slope and curvature meet. The printed one has another branch there, which does not.
  spline
};
/// Returns the names of the penalties on command lines and in scenes.
constexpr ChoiceNames<Penalty, 3> choice_names(Penalty) {
  return {{{"quadratic", Penalty::quadratic}, {"cubic", Penalty::cubic}, {"spline", Penalty::spline}}};
}

/// Primal-dual interior point on the slack form Z_i = S_i(x) - margin I (Nesterov-Todd scaling, Mehrotra's
/// predictor and corrector): no line search, no penalty factor.
struct InteriorPointOptions {
  /// Share of the way to the boundary that a step goes.
  double step_fraction = 0.995;
  /// Smallest eigenvalue of the slacks at the start.
  double least_eigenvalue = 0.1;
  /// Largest number of solves more with every factor to lengthen the step (Gondzio 1996).
  int centrality_corrections = 2;

  /// Visits (Field, member) for each option, see core/option_fields.hpp.
  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    visit(Field{"step_fraction", "Share of the way to the boundary that a step goes", inside(0, 1), "", true},
          self.step_fraction);
    visit(Field{"least_eigenvalue", "Smallest eigenvalue of the slacks at the start", finite(above(0)), "",
                true},
          self.least_eigenvalue);
    visit(Field{"centrality_corrections",
                "Solves more with every factor, at most, to lengthen the step (Gondzio 1996)", at_least(0),
                "", true},
          self.centrality_corrections);
  }
};

/// A path of penalty factors tau, each minimised by Newton's method with the exact Hessian, which is positive
/// definite. Its limit is the optimum of S_i >= (margin + epsilon) I.
struct PenaltyOptions {
  /// The penalty.
  Penalty penalty = Penalty::quadratic;
  /// Eigenvalue above the margin from which on the penalty is zero.
  double epsilon = 1e-6;
  /// Whether epsilon is lowered where x is feasible and the level minimised, so that only epsilon keeps the
  /// gap open. As published it stays, and so may the gap.
  bool lower_epsilon = true;
  double first = 0;   ///< The first tau; 0: 1e3, as published 1.
  double factor = 0;  ///< The factor mu from one tau to the next; 0: 30, as published 10.
  double last = 0;    ///< The last tau; 0: 1e12, of the cubic penalty 1e21, as published 1e15.
  /// Whether algorithm 1 is followed to the letter: the whole path without an early end, every level until
  /// g^T H^-1 g < 1e-14, Armijo's rule on the sums themselves. It stalls in rounding: a level ends after
  /// level_iterations at the latest.
  bool as_published = false;
  /// Iterations after which a level is left, as published.
  int level_iterations = 300;

  /// Visits (Field, member) for each option, see core/option_fields.hpp.
  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    visit(Field{"penalty", "Penalty of the method penalty"}, self.penalty);
    visit(Field{"epsilon", "Eigenvalue above the margin from which on the penalty is zero",
                finite(at_least(0)), "", true},
          self.epsilon);
    visit(Field{"lower_epsilon", "Lower epsilon where only it keeps the gap open", {}, "", true},
          self.lower_epsilon);
    visit(Field{"first", "First penalty factor; 0: 1e3, as published 1", finite(at_least(0)), "", true},
          self.first);
    visit(Field{"factor", "What the penalty factor is multiplied with, above 1; 0: 30, as published 10",
                finite(at_least(0)), "", true},
          self.factor);
    visit(Field{"last", "Last penalty factor; 0: 1e12, of the cubic penalty 1e21, as published 1e15",
                finite(at_least(0)), "", true},
          self.last);
    visit(Field{"as_published", "Follow algorithm 1 of Liu et al. (2016) to the letter", {}, "", true},
          self.as_published);
    visit(Field{"level_iterations", "Iterations after which a penalty factor is left, as published",
                at_least(1), "", true},
          self.level_iterations);
  }
};

/// Multipliers Y_i besides a quadratic penalty. tau grows by `factor`, up to `last`, only where the violation
/// did not fall to a quarter.
struct AugmentedLagrangianOptions {
  double first = 1e3;  ///< The first tau.
  double factor = 10;  ///< The factor by which tau grows.
  double last = 1e7;   ///< The largest tau.
  /// Eigenvalue above the margin that is asked for, S_i >= (margin + epsilon) I: the method comes from
  /// outside.
  double epsilon = 1e-7;
  /// Whether a solve starts from x and Y of the solve before, when nodes and handles are those.
  bool warm_start = true;

  /// Visits (Field, member) for each option, see core/option_fields.hpp.
  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    visit(Field{"first", "First penalty factor", above(0), "", true}, self.first);
    visit(Field{"factor", "What the penalty factor is multiplied with", finite(above(1)), "", true},
          self.factor);
    visit(Field{"last", "Largest penalty factor", finite(above(0)), "", true}, self.last);
    visit(Field{"epsilon", "Eigenvalue above the margin that is asked for, to come from outside",
                finite(at_least(0)), "", true},
          self.epsilon);
    visit(Field{"warm_start", "Start from the result of the solve before", {}, "", true}, self.warm_start);
  }
};

/// The options of inversion-free manipulation.
struct Options {
  /// Makes the defaults. The linear solver is a factorization: systems near the boundary are too badly
  /// conditioned for anything else, and the bound is rigorous only as far as H0 is solved with exactly.
  Options() { solver.backend = sparse::available_backends().front(); }

  /// The method.
  Method method = Method::interior_point;
  /// Relative duality gap at which a solve ends: no feasible x is better by more than this share.
  double gap_tolerance = 1e-6;
  /// Largest number of Newton systems; 0: 60 of interior_point, 2000 of the others.
  int max_iterations = 0;
  InteriorPointOptions interior_point;              ///< Options of Method::interior_point.
  PenaltyOptions penalty;                           ///< Options of Method::penalty.
  AugmentedLagrangianOptions augmented_lagrangian;  ///< Options of Method::augmented_lagrangian.
  sparse::Options solver;                           ///< The solver of the linear systems.
  /// Asked after every iterate; the solve ends as with a callback when it says so.
  StopToken stop;

  /// Visits (Field, member) for each option, see core/option_fields.hpp.
  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    visit(Field{"method", "Algorithm that solves the convex problem"}, self.method);
    visit(Field{"gap_tolerance", "Stop when it is proved that no result is better by more than this share",
                inside(0, 1)},
          self.gap_tolerance);
    visit(Field{"max_iterations",
                "Stop a frame after so many iterations; 0: 60 of interior_point, 2000 of the others",
                at_least(0)},
          self.max_iterations);
    visit(Field{"interior_point", "Options of the method interior_point"}, self.interior_point);
    visit(Field{"penalty", "Options of the method penalty"}, self.penalty);
    visit(Field{"augmented_lagrangian", "Options of the method augmented_lagrangian"},
          self.augmented_lagrangian);
    visit(Field{"linear_solver", "Solver of the linear systems", {}, "", true}, self.solver);
  }

  /// Throws OptionError naming the first option that makes no sense.
  void validate() const;
};

/// Returns the name of a method, such as "interior_point".
std::string_view method_name(Method method) noexcept;
/// Returns the name of a penalty, such as "quadratic".
std::string_view penalty_name(Penalty penalty) noexcept;
/// Returns the method of that name. Throws Error listing the names there are if there is none.
Method method_from_name(std::string_view name);
/// Returns the penalty of that name. Throws Error listing the names there are if there is none.
Penalty penalty_from_name(std::string_view name);
/// Returns all methods.
const std::vector<Method>& all_methods();
/// Returns all penalties.
const std::vector<Penalty>& all_penalties();

}  // namespace isostretch::sdp_penalty
