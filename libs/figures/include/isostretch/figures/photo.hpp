#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace isostretch::figures {

/// A colour times opacity, and the opacity, from 0 to 255.
using Premultiplied = std::array<double, 4>;

/// A picture with an alpha channel. Row 0 is at the top; the middle of the pixel in column i and row j is at
/// (i + 1/2, j + 1/2).
class Photo {
 public:
  /// Makes a transparent picture of a size in pixels.
  Photo(int width, int height);

  /// Returns the width in pixels.
  int width() const { return width_; }
  /// Returns the height in pixels.
  int height() const { return height_; }

  /// Returns a pixel as 0xAARRGGBB, colours times opacity.
  std::uint32_t pixel(int column, int row) const { return pixels_[index(column, row)]; }
  /// Sets a pixel to 0xAARRGGBB, colours times opacity.
  void set_pixel(int column, int row, std::uint32_t value) { pixels_[index(column, row)] = value; }

  /// Returns the colour at a point, bilinear between the middles of pixels; beyond the outermost ones as at
  /// them.
  Premultiplied at(double x, double y) const;

  /// Returns the picture as the bytes of a PNG file.
  std::string png() const;

 private:
  std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(width_) +
           static_cast<std::size_t>(column);
  }

  int width_, height_;
  std::vector<std::uint32_t> pixels_;
};

/// Reads a PNG file of any kind at 8 bits a channel. Throws Error naming the file.
Photo read_photo(const std::filesystem::path& file);

}  // namespace isostretch::figures
