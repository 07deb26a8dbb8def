#pragma once

namespace isostretch {

/// Which step lengths a line search by backtracking tries.
struct Backtracking {
  double first = 1;     ///< the longest step
  double factor = 0.5;  ///< from each to the next
  int tries = 60;       ///< at most
};

/// A verdict on a step that a line search has tried. that it has tried.
enum class Trial { accept, shorten, give_up };

/// A step that a line search has accepted, or the last one tried.
struct BacktrackedStep {
  /// Whether the step gained enough.
  bool accepted = false;
  /// The length of the step, as a share of the direction.
  double step = 0;
  /// The change of the objective by the step.
  double change = 0;
  int evaluations = 0;  ///< steps tried
};

/// Shortens a step until it is accepted: tries `first`, `first * factor` and so on. change(step) returns by
/// how much the objective changes along the step, and judge(step, change) a Trial; Armijo's rule accepts
/// where change <= share * step * slope.
template <class Change, class Judge>
BacktrackedStep backtrack(const Backtracking& tried, const Change& change, const Judge& judge) {
  BacktrackedStep result;
  result.step = tried.first;
  while (result.evaluations < tried.tries) {
    if (result.evaluations > 0) result.step *= tried.factor;
    result.change = change(result.step);
    ++result.evaluations;
    const Trial trial = judge(result.step, result.change);
    result.accepted = trial == Trial::accept;
    if (trial != Trial::shorten) break;
  }
  return result;
}

}  // namespace isostretch
