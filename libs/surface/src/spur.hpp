#pragma once

namespace isostretch::mesh {

// Branches of a cut of fewer edges are spurs, which nobody would draw.
inline constexpr int least_branch = 4;

}  // namespace isostretch::mesh
