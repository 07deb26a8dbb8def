#pragma once

#include "common/figures/color_map.hpp"

#include <cstdint>
#include <vector>

namespace isostretch::app::figures {

// Filled triangles, many and small. A vector renderer that antialiases each triangle for itself lets the
// background shine through every shared edge, and takes seconds for 60k of them; this one takes 3 x 3 samples
// a pixel, each of which belongs to one triangle.
class Raster {
 public:
  Raster(int width, int height, Color background = {1, 1, 1});

  int width() const { return width_; }
  int height() const { return height_; }

  // Corners in pixels, x and y in turn, in either orientation; later triangles cover earlier ones.
  void fill_triangle(const double (&corners)[6], Color color);

  // 0x00RRGGBB row by row, samples averaged.
  std::vector<std::uint32_t> pixels() const;

 private:
  static constexpr int samples = 3;

  int width_;
  int height_;
  std::vector<std::uint32_t> samples_;
};

}  // namespace isostretch::app::figures
