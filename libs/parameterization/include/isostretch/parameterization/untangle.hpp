#pragma once

#include <isostretch/assembly/elements.hpp>
#include <isostretch/core/solve_status.hpp>
#include <isostretch/core/stop_token.hpp>
#include <isostretch/core/vector.hpp>
#include <isostretch/newton/options.hpp>

#include <functional>
#include <vector>

namespace isostretch::parameterization {

struct UntangleOptions {
  /// Weight of (J^2 + 1) / chi, which asks for area 1, beside |F|^2 / chi^(2/dim), which asks for right
  /// angles.
  double area_weight = 1;
  double min_determinant = 0;     ///< of every element, to be exceeded
  int max_rounds = 100;           ///< of regularisation
  int iterations_per_round = 10;  ///< Newton steps in each, fewer when the energy has settled
  newton::Options newton;         ///< everything but its stopping rules
  StopToken stop;                 ///< asked after every round
};

struct UntangleResult {
  bool untangled = false;  ///< every determinant is positive and above min_determinant
  int rounds = 0;
  int iterations = 0;  ///< Newton steps in all
  double smallest_determinant = 0;
  int worst_element = -1;  ///< where
  bool stopped = false;    ///< by options.stop or the callback
};

/// Called after every round with what has come of it so far and the positions.
using UntangleCallback = std::function<CallbackAction(const UntangleResult&, const Vector& x)>;

/// Moves x until no element is inverted or collapsed: minimises |F|^2 / chi^(2/dim) + area_weight (J^2 + 1) /
/// chi with chi = (J + sqrt(epsilon^2 + J^2)) / 2 and an epsilon that shrinks as the worst determinant J
/// rises, by projected Newton ("Foldover-free maps in 50 lines of code", Garanzha et al. 2021). Pinned nodes
/// stay where they are. Succeeds nearly always where a solution exists, but promises nothing: look at
/// `untangled`.
UntangleResult untangle(const assembly::Elements& elements, Vector& x, const UntangleOptions& options = {},
                        const std::vector<int>& pinned_nodes = {}, const UntangleCallback& callback = {});

}  // namespace isostretch::parameterization
