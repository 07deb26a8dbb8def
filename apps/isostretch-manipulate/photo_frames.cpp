#include "photo_frames.hpp"

#include <isostretch/core/text.hpp>
#include <isostretch/figures/photo_warp.hpp>

#include <algorithm>
#include <cmath>

namespace isostretch::app::manipulate {
namespace {

constexpr double largest_side = 16384, most_pixels = 64e6;  // of the pictures

}  // namespace

PhotoFrames::PhotoFrames(const PhotoSpec& spec, const SolidModel& body)
    : body_(body), photo_(figures::read_photo(spec.file)), origin_(0, photo_.height()), scale_(1, 1) {
  if (spec.fit == PhotoFit::pixels) return;
  const Eigen::RowVector2d low = body.nodes.leftCols<2>().colwise().minCoeff(),
                           high = body.nodes.leftCols<2>().colwise().maxCoeff();
  origin_ = {low.x(), high.y()};
  scale_ = Eigen::RowVector2d(photo_.width(), photo_.height()).cwiseQuotient(high - low);
}

mesh::Points2 PhotoFrames::on_photo(const Vector& positions) const {
  mesh::Points2 points = body_.points(positions).leftCols<2>();
  points.col(0) = (points.col(0).array() - origin_.x()) * scale_.x();
  points.col(1) = (origin_.y() - points.col(1).array()) * scale_.y();
  return points;
}

int PhotoFrames::write(OutputFolder& folder) const {
  const mesh::Points2 rest = on_photo(body_.rest_positions());
  Eigen::RowVector2d low = rest.colwise().minCoeff(), high = rest.colwise().maxCoeff();
  for (const Frame& frame : frames_) {
    const mesh::Points2 points = on_photo(frame.positions);
    low = low.cwiseMin(points.colwise().minCoeff());
    high = high.cwiseMax(points.colwise().maxCoeff());
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
    mesh::Points2 points = on_photo(frame.positions);
    points = (points.rowwise() - low) / shrink;
    const figures::PhotoWarp warp{photo_, body_.surface.mesh.triangles, rest, std::move(points)};
    folder.add(formatted("photo_%04d.png", frame.number),
               figures::warped(warp, pixels(high.x() - low.x()), pixels(high.y() - low.y())).png());
  }
  return static_cast<int>(shrink);
}

}  // namespace isostretch::app::manipulate
