#pragma once

#include <cstddef>

namespace isostretch::assembly {

/// The length from which a cheap loop over elements, nodes or blocks is worth a second thread. Shorter ones
/// are over before other threads have woken up: measured, threads that sleep between loops pay from some 8000
/// triangles on, threads that spin from 3000.
inline constexpr std::size_t least_parallel = 4000;

}  // namespace isostretch::assembly
