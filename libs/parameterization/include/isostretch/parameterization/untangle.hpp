#pragma once

#include <isostretch/assembly/elements.hpp>
#include <isostretch/core/solve_status.hpp>
#include <isostretch/core/stop_token.hpp>
#include <isostretch/core/vector.hpp>
#include <isostretch/newton/options.hpp>

#include <functional>
#include <vector>

namespace isostretch::parameterization {

/// The choices of untangle().
struct UntangleOptions {
  /// Weight of (J^2 + 1) / chi, which asks for area 1, beside |F|^2 / chi^(2/dim), which asks for right
  /// angles.
  double area_weight = 1;
  double min_determinant = 0;     ///< The determinant that every element has to exceed.
  int max_rounds = 100;           ///< Largest number of rounds, each with a smaller regularisation.
  int iterations_per_round = 10;  ///< Newton steps in each round, fewer when the energy has settled.
  newton::Options newton;         ///< All options of the minimiser but its stopping rules.
  StopToken stop;                 ///< Asked after every round.
};

/// The result of untangle().
struct UntangleResult {
  bool untangled = false;           ///< Whether every determinant is positive and above min_determinant.
  int rounds = 0;                   ///< Rounds that were made.
  int iterations = 0;               ///< Newton steps in all.
  double smallest_determinant = 0;  ///< Smallest determinant at a quadrature point.
  int worst_element = -1;           ///< Element of the smallest determinant.
  bool stopped = false;             ///< Whether the stop token or the callback ended it.
};

/// A function that is called after every round with what has come of it so far and the positions.
using UntangleCallback = std::function<CallbackAction(const UntangleResult&, const Vector& x)>;

/// Moves x until no element is inverted or collapsed. Minimises |F|^2 / chi^(2/dim) + area_weight (J^2 + 1) /
/// chi with chi = (J + sqrt(epsilon^2 + J^2)) / 2 and an epsilon that shrinks as the worst determinant J
/// rises, by projected Newton (Garanzha et al. 2021, "Foldover-free maps in 50 lines of code"). x has dim
/// entries per node; pinned nodes stay where they are. Succeeds nearly always where a solution exists, but
/// promises nothing: look at `untangled`.
UntangleResult untangle(const assembly::Elements& elements, Vector& x, const UntangleOptions& options = {},
                        const std::vector<int>& pinned_nodes = {}, const UntangleCallback& callback = {});

}  // namespace isostretch::parameterization
