#pragma once

#include <isostretch/core/error.hpp>
#include <isostretch/core/to_text.hpp>

#include <cmath>
#include <limits>
#include <string>

namespace isostretch::mesh {

inline void require_count(const char* what, int value, int least = 1) {
  if (value < least)
    throw Error(std::string(what) + " is " + std::to_string(value) + ", must be at least " +
                std::to_string(least));
}

inline void require_length(const char* what, double value) {
  if (!(value > 0 && std::isfinite(value)))
    throw Error(std::string(what) + " is " + isostretch::to_text(value) + ", must be positive");
}

// Products of three counts below 2^31 each fit a double closely enough to tell.
inline void require_indexable(double elements) {
  if (6 * elements > std::numeric_limits<int>::max()) throw Error("the mesh asked for has too many elements");
}

}  // namespace isostretch::mesh
