#pragma once

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
  skinning               // the minimiser without constraints alone (tau = 0): may have inverted elements
};

// On negative eigenvalues of S - margin I, with y = lambda - epsilon (Liu et al. 2016, section 4).
enum class Penalty {
  quadratic,  // tau y^2 for y < 0
  cubic,      // -tau y^3 for y < 0: its violation falls with the square root of tau only
  spline  // -log(1 + tau y) / tau, continued by 2 tau y^2 - (log 1/2 + 1/2) / tau below tau y = -1/2, where
          // value, slope and curvature meet; the printed one has another branch there, which does not
};

// Primal-dual interior point on the slack form Z_i = S_i(x) - margin I (Nesterov-Todd scaling, Mehrotra's
// predictor and corrector): no line search, no penalty factor.
struct InteriorPointOptions {
  double step_fraction = 0.995;   // of the way to the boundary
  double least_eigenvalue = 0.1;  // of the slacks at the start
  // At most so many solves more with every factor to lengthen the step (Gondzio 1996).
  int centrality_corrections = 2;
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
};

// Multipliers Y_i besides a quadratic penalty. tau grows by `factor`, up to `last`, only where the violation
// did not fall to a quarter.
struct AugmentedLagrangianOptions {
  double first = 1e3, factor = 10, last = 1e7;  // tau
  double epsilon = 1e-7;   // S_i >= (margin + epsilon) I is solved: it comes from outside
  bool warm_start = true;  // from x and Y of the solve before, when nodes and handles are those
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

  // Throws Error naming the first option that makes no sense.
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
