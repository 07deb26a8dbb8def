#pragma once

#include <isostretch/figures/deformation_figure.hpp>

#include <string>
#include <vector>

namespace isostretch::figures {

/// An iterate of a solve that ends without inverted elements.
struct IterateRow {
  int iteration = 0;      ///< Number of the iteration.
  double seconds = 0;     ///< Seconds since the solve began.
  int inverted = 0;       ///< Elements with det F <= 0.
  double gap = 0;         ///< Relative gap between energy and lower bound; 0 where there is none to speak of.
  bool feasible = false;  ///< Whether all elements satisfy the constraints.
};

/// The number of iterates that the figure has room for, side by side.
inline constexpr int shown_iterates = 6;

/// Returns the relative gap between an energy and a lower bound; 0 where it is not finite or not positive:
/// the energy of positions that are not feasible may lie below the bound.
double relative_gap(double energy, double lower_bound);

/// Returns a figure of how a solve went: the states of `figure` in a row, each with what its row of `shown`
/// says, and below how many elements are inverted and how large the gap is over the seconds of all rows of
/// `trace`. There are as many states as rows shown, six at most. The bytes of a PNG 1600 pixels wide.
std::string draw_iterates(const DeformationFigure& figure, const std::vector<IterateRow>& shown,
                          const std::vector<IterateRow>& trace);

}  // namespace isostretch::figures
