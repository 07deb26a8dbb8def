#pragma once

#include <isostretch/figures/color_map.hpp>

#include <cstdint>
#include <vector>

namespace isostretch::figures {

/// A picture of filled triangles, many and small. A vector renderer that antialiases each triangle for itself
/// lets the background shine through every shared edge, and takes seconds for 60k of them; this one takes 3 x
/// 3 samples a pixel, each of which belongs to one triangle.
class Raster {
 public:
  static constexpr int samples = 3;  ///< Samples of a pixel, each way.

  /// Makes a picture of a size in pixels, filled with the background.
  Raster(int width, int height, Color background = {1, 1, 1});

  /// Returns the width in pixels.
  int width() const { return width_; }
  /// Returns the height in pixels.
  int height() const { return height_; }

  /// Returns the number of samples in a row.
  int columns() const { return width_ * samples; }
  /// Returns the number of samples in a column.
  int rows() const { return height_ * samples; }

  /// Fills a triangle. Corners are in pixels, x and y in turn, in either orientation; later triangles cover
  /// earlier ones.
  void fill_triangle(const double (&corners)[6], Color color);

  /// Fills a triangle with stripes of the colour, which go on from triangle to triangle.
  void hatch_triangle(const double (&corners)[6], Color color);

  /// Sets one sample, for pictures that are computed sample by sample.
  void set_sample(int column, int row, Color color);

  /// Returns the pixels as 0x00RRGGBB row by row, samples averaged.
  std::vector<std::uint32_t> pixels() const;

 private:
  int width_;
  int height_;
  std::vector<std::uint32_t> samples_;
};

}  // namespace isostretch::figures
