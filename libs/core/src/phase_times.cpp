#include <isostretch/core/phase_times.hpp>

#include <algorithm>

namespace isostretch {
namespace {

template <class Phases>
auto find(Phases& phases, std::string_view phase) {
  return std::find_if(phases.begin(), phases.end(), [&](const auto& entry) { return entry.first == phase; });
}

}  // namespace

void PhaseTimes::add(std::string_view phase, double seconds) {
  const auto found = find(phases_, phase);
  if (found == phases_.end())
    phases_.emplace_back(phase, seconds);
  else
    found->second += seconds;
}

double PhaseTimes::seconds(std::string_view phase) const {
  const auto found = find(phases_, phase);
  return found == phases_.end() ? 0 : found->second;
}

}  // namespace isostretch
