#pragma once

#include "common/deformation_names.hpp"

#include "common/output_folder.hpp"
#include "scene.hpp"

#include <isostretch/figures/photo.hpp>

#include <string>
#include <vector>

namespace isostretch::app::manipulate {

// The photo that a body in the plane covers, drawn as the body is deformed.
class PhotoFrames {
 public:
  // Throws Error naming the file.
  PhotoFrames(const PhotoSpec& spec, const SolidModel& body);

  void add(int frame, const Vector& positions) { frames_.push_back({frame, positions}); }

  // photo_0001.png and so on, all of one size: the box around the rest shape and the frames added, at the
  // photo's scale, or smaller by the whole number returned where that would be too large a picture.
  int write(OutputFolder& folder) const;

 private:
  struct Frame {
    int number;
    Vector positions;
  };

  mesh::Points2 on_photo(const Vector& positions) const;

  const SolidModel& body_;
  figures::Photo photo_;
  Eigen::RowVector2d origin_, scale_;  // upper left corner, and pixels a unit
  std::vector<Frame> frames_;
};

}  // namespace isostretch::app::manipulate
