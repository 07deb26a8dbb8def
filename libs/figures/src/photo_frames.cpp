#include <isostretch/figures/photo_frames.hpp>
#include <isostretch/figures/photo_warp.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace isostretch::figures {
namespace {

constexpr double largest_side = 16384, most_pixels = 64e6;  // of the pictures

}  // namespace

PhotoPlacement filling_box(const Photo& photo, const mesh::Points2& points) {
  const Eigen::RowVector2d low = points.colwise().minCoeff(), high = points.colwise().maxCoeff();
  return {{low.x(), high.y()}, {photo.width() / (high - low).x(), photo.height() / (high - low).y()}};
}

PhotoPlacement unit_pixels(const Photo& photo) {
  return {{0, static_cast<double>(photo.height())}, {1, 1}};
}

PhotoFrames::PhotoFrames(Photo photo, const PhotoPlacement& placement, const mesh::Triangles& triangles,
                         const mesh::Points2& rest)
    : photo_(std::move(photo)), placement_(placement), triangles_(triangles), rest_(on_photo(rest)) {}

void PhotoFrames::add(int number, const mesh::Points2& vertices) {
  frames_.push_back({number, on_photo(vertices)});
}

mesh::Points2 PhotoFrames::on_photo(const mesh::Points2& vertices) const {
  mesh::Points2 points = vertices;
  points.col(0) = (points.col(0).array() - placement_.origin[0]) * placement_.scale[0];
  points.col(1) = (placement_.origin[1] - points.col(1).array()) * placement_.scale[1];
  return points;
}

int PhotoFrames::draw(const std::function<void(int number, const std::string& png)>& take) const {
  Eigen::RowVector2d low = rest_.colwise().minCoeff(), high = rest_.colwise().maxCoeff();
  for (const Frame& frame : frames_) {
    low = low.cwiseMin(frame.on_photo.colwise().minCoeff());
    high = high.cwiseMax(frame.on_photo.colwise().maxCoeff());
  }
  // Whole pixels, so that what does not move is not sampled between pixels; and no pixel for rounding.
  low = (low.array() + 1e-6).floor();
  high = (high.array() - 1e-6).ceil();
  const double shrink = std::max({1.0, std::ceil((high - low).maxCoeff() / largest_side),
                                  std::ceil(std::sqrt((high - low).prod() / most_pixels))});
  const auto pixels = [&](double length) {
    return std::max(1, static_cast<int>(std::ceil(length / shrink)));
  };
  for (const Frame& frame : frames_) {
    mesh::Points2 points = frame.on_photo;
    points = (points.rowwise() - low) / shrink;
    const PhotoWarp warp{photo_, triangles_, rest_, std::move(points)};
    take(frame.number, warped(warp, pixels(high.x() - low.x()), pixels(high.y() - low.y())).png());
  }
  return static_cast<int>(shrink);
}

}  // namespace isostretch::figures
