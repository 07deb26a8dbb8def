#pragma once

#include <isostretch/core/monitor.hpp>
#include <isostretch/newton/options.hpp>

namespace isostretch::deformation {

// The options of one frame of several whose limit of time, which the monitor has, is that of all together.
inline newton::Options options_of_frame(newton::Options options, const Monitor& monitor) {
  options.time_limit = 0;
  options.stop = monitor.stop;
  return options;
}

}  // namespace isostretch::deformation
