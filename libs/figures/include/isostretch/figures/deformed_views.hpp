#pragma once

#include <isostretch/figures/canvas.hpp>
#include <isostretch/figures/deformation_figure.hpp>
#include <isostretch/figures/distortion_scale.hpp>

#include <memory>

namespace isostretch::figures {

/// Views of the states of a body, seen by one camera that fits the first, all at one scale.
class DeformedViews {
 public:
  /// Prepares views `width` pixels wide and at most `most_height` high, with `inset` pixels of room around
  /// the largest state. The figure must outlive this object.
  DeformedViews(const DeformationFigure& figure, int width, double most_height, double inset);
  ~DeformedViews();
  DeformedViews(const DeformedViews&) = delete;
  DeformedViews& operator=(const DeformedViews&) = delete;

  /// Returns the height that the highest state needs, in pixels.
  double height() const { return height_; }

  /// Draws a state with its upper left corner at a point of the canvas.
  void draw(Canvas& canvas, std::size_t state, Point corner, int height, const DistortionScale& scale) const;

 private:
  struct Workspace;
  std::unique_ptr<Workspace> workspace_;
  int width_;
  double scale_ = 1, height_ = 0;
};

}  // namespace isostretch::figures
