#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace isostretch {

/// A record of wall-clock seconds by phase, in the order in which the phases were first named.
class PhaseTimes {
 public:
  /// Adds seconds to a phase, which is new if it was not named before.
  void add(std::string_view phase, double seconds);
  /// Returns the seconds of a phase; 0 for a phase that was never named.
  double seconds(std::string_view phase) const;
  /// Returns the names and seconds of all phases, in the order in which they were first named.
  const std::vector<std::pair<std::string, double>>& phases() const { return phases_; }

 private:
  std::vector<std::pair<std::string, double>> phases_;
};

}  // namespace isostretch
