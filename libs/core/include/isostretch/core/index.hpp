#pragma once

#include <cstddef>

namespace isostretch {

/// Returns an index that is not negative as one of a container of the standard library.
constexpr std::size_t at(int i) noexcept {
  return static_cast<std::size_t>(i);
}

}  // namespace isostretch
