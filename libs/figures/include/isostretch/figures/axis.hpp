#pragma once

#include <string>
#include <vector>

namespace isostretch::figures {

/// A mark on an axis.
struct Tick {
  double value = 0;   ///< Value at the mark.
  std::string label;  ///< Number beside the mark; empty for a mark without one.
};

/// A range of values with ticks at round numbers.
struct Axis {
  double low = 0;            ///< Value at the beginning.
  double high = 1;           ///< Value at the end.
  bool logarithmic = false;  ///< Whether positions are linear in the logarithm of values.
  std::vector<Tick> ticks;   ///< Ticks, ascending.

  /// Returns the position of a value: 0 at low, 1 at high.
  double position(double value) const;
};

/// Returns an axis from 0 to at least `high` in at most `most_ticks` round steps; whole numbers only if
/// asked.
Axis linear_axis(double high, int most_ticks, bool whole = false);

/// Returns an axis of whole decades around positive values [low, high], labelled as powers of ten.
Axis decade_axis(double low, double high, int most_ticks);

/// Returns a logarithmic axis of exactly [low, high], with ticks at round numbers inside, also when that is
/// less than a decade.
Axis narrow_log_axis(double low, double high, int most_ticks);

}  // namespace isostretch::figures
