#pragma once

#include <cstddef>

namespace isostretch::mesh {

/// Returns an index of a mesh as one of a container.
inline std::size_t at(int i) {
  return static_cast<std::size_t>(i);
}

}  // namespace isostretch::mesh
