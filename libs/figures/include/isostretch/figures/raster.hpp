#pragma once

#include <isostretch/figures/color_map.hpp>

#include <cstdint>
#include <vector>

namespace isostretch::figures {

/// Filled triangles, many and small. A vector renderer that antialiases each triangle for itself lets the
/// background shine through every shared edge, and takes seconds for 60k of them; this one takes 3 x 3
/// samples a pixel, each of which belongs to one triangle.
class Raster {
 public:
  static constexpr int samples = 3;  ///< a pixel, each way

  Raster(int width, int height, Color background = {1, 1, 1});

  int width() const { return width_; }
  int height() const { return height_; }

  /// Samples in a row and in a column of the picture.
  int columns() const { return width_ * samples; }
  int rows() const { return height_ * samples; }

  /// Corners in pixels, x and y in turn, in either orientation; later triangles cover earlier ones.
  void fill_triangle(const double (&corners)[6], Color color);

  /// Stripes of the color, which go on from triangle to triangle.
  void hatch_triangle(const double (&corners)[6], Color color);

  /// One sample, for pictures that are computed sample by sample.
  void set_sample(int column, int row, Color color);

  /// 0x00RRGGBB row by row, samples averaged.
  std::vector<std::uint32_t> pixels() const;

 private:
  int width_;
  int height_;
  std::vector<std::uint32_t> samples_;
};

}  // namespace isostretch::figures
