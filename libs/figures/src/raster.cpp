
#include <isostretch/figures/raster.hpp>
#include <isostretch/figures/scan_triangle.hpp>

#include <algorithm>
#include <cmath>

namespace isostretch::figures {
namespace {

std::uint32_t packed(Color color) {
  const auto byte = [](double c) { return static_cast<std::uint32_t>(255 * c + 0.5); };
  return byte(color.r) << 16U | byte(color.g) << 8U | byte(color.b);
}

}  // namespace

Raster::Raster(int width, int height, Color background)
    : width_(width),
      height_(height),
      samples_(static_cast<std::size_t>(width * samples) * static_cast<std::size_t>(height * samples),
               packed(background)) {}

void Raster::fill_triangle(const double (&corners)[6], Color color) {
  double p[6];
  for (int i = 0; i < 6; ++i) p[i] = corners[i] * samples;
  const std::uint32_t value = packed(color);
  scan_triangle(p, columns(), rows(), [&](int row, int from, int to) {
    const auto start = samples_.begin() + static_cast<std::ptrdiff_t>(row) * columns();
    std::fill(start + from, start + to, value);
  });
}

void Raster::hatch_triangle(const double (&corners)[6], Color color) {
  constexpr int period = 7 * samples, stripe = 2 * samples;
  double p[6];
  for (int i = 0; i < 6; ++i) p[i] = corners[i] * samples;
  scan_triangle(p, columns(), rows(), [&](int row, int from, int to) {
    for (int column = from; column < to; ++column)
      if ((column + row) % period < stripe) set_sample(column, row, color);
  });
}

void Raster::set_sample(int column, int row, Color color) {
  samples_[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns()) +
           static_cast<std::size_t>(column)] = packed(color);
}

std::vector<std::uint32_t> Raster::pixels() const {
  std::vector<std::uint32_t> result;
  result.reserve(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_));
  const auto stride = static_cast<std::size_t>(width_ * samples);
  for (int y = 0; y < height_; ++y)
    for (int x = 0; x < width_; ++x) {
      std::uint32_t r = 0, g = 0, b = 0;
      for (int j = 0; j < samples; ++j)
        for (int i = 0; i < samples; ++i) {
          const std::uint32_t s = samples_[static_cast<std::size_t>(y * samples + j) * stride +
                                           static_cast<std::size_t>(x * samples + i)];
          r += s >> 16U & 255U, g += s >> 8U & 255U, b += s & 255U;
        }
      constexpr std::uint32_t n = samples * samples;
      result.push_back((r + n / 2) / n << 16U | (g + n / 2) / n << 8U | (b + n / 2) / n);
    }
  return result;
}

}  // namespace isostretch::figures
