#pragma once

#include <isostretch/figures/canvas.hpp>
#include <isostretch/figures/deformation_figure.hpp>
#include <isostretch/figures/distortion_scale.hpp>

#include <memory>

namespace isostretch::figures {

/// The states of a body, seen by one camera that fits the first, all at one scale.
class DeformedViews {
 public:
  /// For views so many pixels wide and at most so high, with that much room around the largest state. The
  /// figure must live longer.
  DeformedViews(const DeformationFigure& figure, int width, double most_height, double inset);
  ~DeformedViews();
  DeformedViews(const DeformedViews&) = delete;
  DeformedViews& operator=(const DeformedViews&) = delete;

  /// What the highest state needs.
  double height() const { return height_; }

  void draw(Canvas& canvas, std::size_t state, Point corner, int height, const DistortionScale& scale) const;

 private:
  struct Kept;
  std::unique_ptr<Kept> kept_;
  int width_;
  double scale_ = 1, height_ = 0;
};

}  // namespace isostretch::figures
