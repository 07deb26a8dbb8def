#include "common/figures/raster.hpp"

#include <algorithm>
#include <cmath>

namespace isostretch::app::figures {
namespace {

std::uint32_t packed(Color color) {
  const auto byte = [](double c) { return static_cast<std::uint32_t>(std::lround(255 * c)); };
  return byte(color.r) << 16U | byte(color.g) << 8U | byte(color.b);
}

// Where the line from a to b crosses the row y widens the span [left, right].
struct Span {
  double left = HUGE_VAL, right = -HUGE_VAL;

  void cross(const double* a, const double* b, double y) {
    if ((a[1] <= y) == (b[1] <= y)) return;
    const double x = a[0] + (b[0] - a[0]) * ((y - a[1]) / (b[1] - a[1]));
    left = std::min(left, x);
    right = std::max(right, x);
  }
};

// First sample centre at or beyond a coordinate, kept in [0, count]; NaN gives 0.
int first_sample(double coordinate, int count) {
  const double c = std::ceil(coordinate - 0.5);
  return c > 0 ? static_cast<int>(std::min(c, static_cast<double>(count))) : 0;
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
  const int columns = width_ * samples, rows = height_ * samples;
  const std::uint32_t value = packed(color);
  const int last = first_sample(std::max({p[1], p[3], p[5]}), rows);
  for (int row = first_sample(std::min({p[1], p[3], p[5]}), rows); row < last; ++row) {
    Span span;
    span.cross(p, p + 2, row + 0.5);
    span.cross(p + 2, p + 4, row + 0.5);
    span.cross(p + 4, p, row + 0.5);
    const int from = first_sample(span.left, columns), to = first_sample(span.right, columns);
    const auto start = samples_.begin() + static_cast<std::ptrdiff_t>(row) * columns;
    if (from < to) std::fill(start + from, start + to, value);
  }
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

}  // namespace isostretch::app::figures
