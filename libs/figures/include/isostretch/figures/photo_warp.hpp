#pragma once

#include <isostretch/figures/photo.hpp>
#include <isostretch/mesh/types.hpp>

namespace isostretch::figures {

/// Triangles over a photo and where they go, both in pixels of the pictures, y downwards.
struct PhotoWarp {
  const Photo& photo;
  const mesh::Triangles& triangles;
  mesh::Points2 on_photo;  ///< vertices
  mesh::Points2 on_result;
};

/// The photo drawn through the triangles, with 2 x 2 samples a pixel, transparent where there is none; later
/// triangles cover earlier ones. Where triangles stay as they are, so does the photo, to within rounding.
Photo warped(const PhotoWarp& warp, int width, int height);

}  // namespace isostretch::figures
