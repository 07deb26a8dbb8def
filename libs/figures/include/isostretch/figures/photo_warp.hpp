#pragma once

#include <isostretch/figures/photo.hpp>
#include <isostretch/mesh/types.hpp>

namespace isostretch::figures {

/// A warp of a photo: triangles over it and where they go, both in pixels of the pictures, y downwards.
struct PhotoWarp {
  const Photo& photo;                ///< The photo.
  const mesh::Triangles& triangles;  ///< Triangles over the photo.
  mesh::Points2 on_photo;            ///< V x 2, vertices in the photo.
  mesh::Points2 on_result;           ///< V x 2, vertices in the result.
};

/// Returns the photo drawn through the triangles, with 2 x 2 samples a pixel, transparent where there is
/// none; later triangles cover earlier ones. Where triangles stay as they are, so does the photo, to within
/// rounding.
Photo warped(const PhotoWarp& warp, int width, int height);

}  // namespace isostretch::figures
