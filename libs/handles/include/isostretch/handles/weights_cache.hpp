#pragma once

#include <isostretch/assembly/elements.hpp>
#include <isostretch/handles/bounded_weights.hpp>

#include <filesystem>
#include <vector>

namespace isostretch::handles {

/// Weights, and the file in which they are kept.
struct CachedWeights {
  HandleWeights weights;       ///< The weights of all handles.
  bool hit = false;            ///< Whether they were read from the file, not computed.
  std::filesystem::path file;  ///< The file in which they are now.
};

/// Returns bounded_biharmonic_weights(), kept in a file of the folder, which is made if need be. The file is
/// named by a fingerprint of 128 bits of the elements, the sets of nodes of the handles, the tolerance, and
/// the version of the format; the solver, which changes rounding alone, does not count. A file that is
/// damaged, cut short or not of ours is computed anew and replaced. Files are of the byte order of the
/// machine. Throws what bounded_biharmonic_weights() throws, and Error naming the folder when it cannot be
/// made, the file when it cannot be written.
CachedWeights cached_weights(const std::filesystem::path& folder, const assembly::Elements& elements,
                             const std::vector<std::vector<int>>& handles, const WeightOptions& options = {});

}  // namespace isostretch::handles
