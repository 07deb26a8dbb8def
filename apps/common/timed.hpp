#pragma once

#include <isostretch/core/timer.hpp>

#include <utility>

namespace isostretch::app {

// Adds the time that the work takes.
template <class Work>
auto timed(double& seconds, Work&& work) {
  const ScopedTimer timer(seconds);
  return std::forward<Work>(work)();
}

}  // namespace isostretch::app
