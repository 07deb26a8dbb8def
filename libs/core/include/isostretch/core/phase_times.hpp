#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace isostretch {

/// Wall-clock seconds by phase, in the order in which phases were first named.
class PhaseTimes {
 public:
  /// Adds seconds to a phase.
  void add(std::string_view phase, double seconds);
  /// Returns the seconds of a phase; 0 for one that was never named.
  double seconds(std::string_view phase) const;
  const std::vector<std::pair<std::string, double>>& phases() const { return phases_; }

 private:
  std::vector<std::pair<std::string, double>> phases_;
};

}  // namespace isostretch
