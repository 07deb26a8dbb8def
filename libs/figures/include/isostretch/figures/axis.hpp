#pragma once

#include <string>
#include <vector>

namespace isostretch::figures {

struct Tick {
  double value = 0;
  std::string label;  ///< empty: a mark without a number
};

/// A range of values with ticks at round numbers.
struct Axis {
  double low = 0;
  double high = 1;
  bool logarithmic = false;
  std::vector<Tick> ticks;

  /// Position of a value: 0 at low, 1 at high.
  double position(double value) const;
};

/// From 0 to at least `high` in at most `most_ticks` round steps; whole numbers only if asked.
Axis linear_axis(double high, int most_ticks, bool whole = false);

/// Whole decades around positive values [low, high], labelled as powers of ten.
Axis decade_axis(double low, double high, int most_ticks);

/// Exactly [low, high], logarithmic, with ticks at round numbers inside, also when that is less than a
/// decade.
Axis narrow_log_axis(double low, double high, int most_ticks);

}  // namespace isostretch::figures
