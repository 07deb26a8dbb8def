#pragma once

#include <isostretch/core/option_fields.hpp>
#include <isostretch/core/stop_token.hpp>
#include <isostretch/sparse/options.hpp>

#include <string_view>
#include <vector>

namespace isostretch::sdp_penalty {

enum class Method {
  interior_point,        // the default: fewest factorizations, flat in resolution
  augmented_lagrangian,  // needs no large penalty factor; warm starts from the drag before
  penalty,               // Liu et al. 2016: a path of penalty factors
  spectral_sdp,          // multipliers with a quadratic-logarithmic term (Apkarian et al. 2004)
  pennon,                // multipliers with a reciprocal barrier (Kocvara, Stingl 2003)
  unconstrained          // the minimiser without constraints alone (tau = 0): may have inverted elements
};
constexpr ChoiceNames<Method, 6> choice_names(Method) {
  return {{{"interior_point", Method::interior_point},
           {"augmented_lagrangian", Method::augmented_lagrangian},
           {"penalty", Method::penalty},
           {"spectral_sdp", Method::spectral_sdp},
           {"pennon", Method::pennon},
           {"unconstrained", Method::unconstrained}}};
}

// On negative eigenvalues of S - margin I, with y = lambda - epsilon (Liu et al. 2016, section 4).
enum class Penalty {
  quadratic,  // tau y^2 for y < 0
  cubic,      // -tau y^3 for y < 0: its violation falls with the square root of tau only
  spline  // -log(1 + tau y) / tau, continued by 2 tau y^2 - (log 1/2 + 1/2) / tau below tau y = -1/2, where
          // value, slope and curvature meet; the printed one has another branch there, which does not
};
constexpr ChoiceNames<Penalty, 3> choice_names(Penalty) {
  return {{{"quadratic", Penalty::quadratic}, {"cubic", Penalty::cubic}, {"spline", Penalty::spline}}};
}

// Primal-dual interior point on the slack form Z_i = S_i(x) - margin I (Nesterov-Todd scaling, Mehrotra's
// predictor and corrector): no line search, no penalty factor.
struct InteriorPointOptions {
  double step_fraction = 0.995;   // of the way to the boundary
  double least_eigenvalue = 0.1;  // of the slacks at the start
  // At most so many solves more with every factor to lengthen the step (Gondzio 1996).
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

// A path of penalty factors tau, each minimised by Newton's method with the exact Hessian, which is positive
// definite. Its limit is the optimum of S_i >= (margin + epsilon) I.
struct PenaltyOptions {
  Penalty penalty = Penalty::quadratic;
  double epsilon = 1e-6;
  // Where x is feasible and the level minimised, only epsilon keeps the gap open: it is lowered then. false,
  // and as published: it stays, and so may the gap.
  bool lower_epsilon = true;
  double first = 0;   // tau; 0: 1e3, as published 1
  double factor = 0;  // mu; 0: 30, as published 10
  double last = 0;    // 0: 1e12, of the cubic penalty 1e21; as published 1e15
  // Algorithm 1 to the letter: the whole path without an early end, every level until g^T H^-1 g < 1e-14,
  // Armijo's rule on the sums themselves. It stalls in rounding: a level ends after level_iterations at the
  // latest.
  bool as_published = false;
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

// Multipliers Y_i besides a quadratic penalty. tau grows by `factor`, up to `last`, only where the violation
// did not fall to a quarter.
struct AugmentedLagrangianOptions {
  double first = 1e3, factor = 10, last = 1e7;  // tau
  double epsilon = 1e-7;   // S_i >= (margin + epsilon) I is solved: it comes from outside
  bool warm_start = true;  // from x and Y of the solve before, when nodes and handles are those

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

struct Options {
  // A factorization: systems near the boundary are too badly conditioned for anything else, and the bound is
  // rigorous only as far as H0 is solved with exactly.
  Options() { solver.backend = sparse::available_backends().front(); }

  Method method = Method::interior_point;
  double gap_tolerance = 1e-6;  // certified, relative
  int max_iterations = 0;       // Newton systems; 0: 60 of interior_point, 2000 of the others
  InteriorPointOptions interior_point;
  PenaltyOptions penalty;
  AugmentedLagrangianOptions augmented_lagrangian;
  sparse::Options solver;
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

// Names as on a command line: the enumerator's own. The inverse throws Error listing the names there are.
std::string_view method_name(Method method) noexcept;
std::string_view penalty_name(Penalty penalty) noexcept;
Method method_from_name(std::string_view name);
Penalty penalty_from_name(std::string_view name);
const std::vector<Method>& all_methods();
const std::vector<Penalty>& all_penalties();

}  // namespace isostretch::sdp_penalty
