#pragma once

#include <isostretch/figures/photo.hpp>
#include <isostretch/mesh/types.hpp>

#include <array>
#include <functional>
#include <string>
#include <vector>

namespace isostretch::figures {

/// How a photo lies on the plane of a mesh.
struct PhotoPlacement {
  std::array<double, 2> origin{0, 0};  ///< Upper left corner of the photo.
  std::array<double, 2> scale{1, 1};   ///< Pixels a unit.
};

/// Returns the placement that fills the box around the points.
PhotoPlacement filling_box(const Photo& photo, const mesh::Points2& points);
/// Returns the placement with a pixel a unit, and the origin of the plane at the lower left corner.
PhotoPlacement unit_pixels(const Photo& photo);

/// The photo that triangles in the plane cover, drawn as these move, frame by frame.
class PhotoFrames {
 public:
  /// Takes the photo and V x 2 vertices at rest; the triangles must outlive this object.
  PhotoFrames(Photo photo, const PhotoPlacement& placement, const mesh::Triangles& triangles,
              const mesh::Points2& rest);

  /// Adds a frame: its number and the V x 2 vertices.
  void add(int number, const mesh::Points2& vertices);

  /// Draws the frames added, each handed to `take` with its number as the bytes of a PNG. All are of one
  /// size: the box around the vertices at rest and in all frames, at the photo's scale, or smaller by the
  /// whole number returned where that would be too large a picture.
  int draw(const std::function<void(int number, const std::string& png)>& take) const;

 private:
  struct Frame {
    int number;
    mesh::Points2 on_photo;
  };

  mesh::Points2 on_photo(const mesh::Points2& vertices) const;

  Photo photo_;
  PhotoPlacement placement_;
  const mesh::Triangles& triangles_;
  mesh::Points2 rest_;  // on the photo
  std::vector<Frame> frames_;
};

}  // namespace isostretch::figures
