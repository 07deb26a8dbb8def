
#include <isostretch/figures/photo_warp.hpp>
#include <isostretch/figures/scan_triangle.hpp>

#include <Eigen/LU>

#include <cmath>

namespace isostretch::figures {
namespace {

constexpr int samples = 2;  // a pixel, each way

using Corners = Eigen::Matrix<double, 3, 2>;

// From a point of the result to one of the photo, exact at the corners of a triangle.
class Way {
 public:
  // Not invertible: the triangle has no area, and no sample lies in it.
  Way(const Corners& from, const Corners& to) : from_(from.row(0)), to_(to.row(0)) {
    const auto edges = [](const Corners& c) {
      Eigen::Matrix2d e;
      e << c.row(1) - c.row(0), c.row(2) - c.row(0);
      return e;
    };
    const Eigen::Matrix2d source = edges(from);
    invertible_ = std::abs(source.determinant()) > 0;
    if (invertible_) linear_ = source.inverse() * edges(to);
  }

  bool invertible() const { return invertible_ && linear_.allFinite(); }
  Eigen::RowVector2d operator()(const Eigen::RowVector2d& p) const { return to_ + (p - from_) * linear_; }

 private:
  Eigen::RowVector2d from_, to_;
  Eigen::Matrix2d linear_ = Eigen::Matrix2d::Zero();
  bool invertible_ = false;
};

std::uint32_t packed(const Premultiplied& channels) {
  std::uint32_t result = 0;
  for (std::size_t k = 0; k < 4; ++k)
    result |= static_cast<std::uint32_t>(std::lround(channels[k])) << (8 * k);
  return result;
}

// What a sample shows. Samples share the colour of their pixel's middle as long as that is within a pixel of
// the photo of them, so that the photo is not blurred; where it is shrunk, each has its own.
std::uint32_t color_at(const Photo& photo, const Way& way, int column, int row) {
  const Eigen::RowVector2d sample((column + 0.5) / samples, (row + 0.5) / samples);
  const Eigen::RowVector2d middle(column / samples + 0.5, row / samples + 0.5);
  const Eigen::RowVector2d own = way(sample), shared = way(middle);
  const Eigen::RowVector2d& p = (shared - own).norm() <= 1 ? shared : own;
  return packed(photo.at(p.x(), p.y()));
}

class Samples {
 public:
  Samples(int width, int height)
      : columns_(width * samples),
        rows_(height * samples),
        values_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_), 0U) {}

  int columns() const { return columns_; }
  int rows() const { return rows_; }
  std::uint32_t& at(int column, int row) {
    return values_[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
                   static_cast<std::size_t>(column)];
  }

  std::uint32_t pixel(int column, int row) {
    Premultiplied mean{};
    for (int j = 0; j < samples; ++j)
      for (int i = 0; i < samples; ++i)
        for (std::size_t k = 0; k < 4; ++k)
          mean[k] += static_cast<double>((at(samples * column + i, samples * row + j) >> (8 * k)) & 0xFFU) /
                     (samples * samples);
    return packed(mean);
  }

 private:
  int columns_, rows_;
  std::vector<std::uint32_t> values_;
};

Corners corners(const mesh::Points2& points, const mesh::Triangles& triangles, Eigen::Index t) {
  Corners result;
  for (int c = 0; c < 3; ++c) result.row(c) = points.row(triangles(t, c));
  return result;
}

}  // namespace

Photo warped(const PhotoWarp& warp, int width, int height) {
  Samples result(width, height);
  for (Eigen::Index t = 0; t < warp.triangles.rows(); ++t) {
    const Corners place = corners(warp.on_result, warp.triangles, t);
    const Way way(place, corners(warp.on_photo, warp.triangles, t));
    if (!way.invertible()) continue;
    const double p[6] = {samples * place(0, 0), samples * place(0, 1), samples * place(1, 0),
                         samples * place(1, 1), samples * place(2, 0), samples * place(2, 1)};
    scan_triangle(p, result.columns(), result.rows(), [&](int row, int from, int to) {
      for (int column = from; column < to; ++column)
        result.at(column, row) = color_at(warp.photo, way, column, row);
    });
  }
  Photo photo(width, height);
  for (int row = 0; row < height; ++row)
    for (int column = 0; column < width; ++column) photo.set_pixel(column, row, result.pixel(column, row));
  return photo;
}

}  // namespace isostretch::figures
