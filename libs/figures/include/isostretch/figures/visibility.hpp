#pragma once

#include <isostretch/figures/camera.hpp>

#include <vector>

namespace isostretch::figures {

/// The nearest triangle at every sample of a picture, by its number. Colours are computed afterwards, once a
/// sample, however many triangles lie behind each other.
class Visibility {
 public:
  /// The number of a sample without a triangle.
  static constexpr int nothing = -1, line = -2;  ///< The number of a sample of a line.

  /// Makes a picture of samples without triangles.
  Visibility(int columns, int rows);

  /// Adds a triangle, corners in samples.
  void add_triangle(int number, const ScreenPoint& a, const ScreenPoint& b, const ScreenPoint& c);
  /// Adds a line, ends and width in samples, after all triangles. `slack` is how much nearer, as a share, the
  /// line counts than it is, so that it is not lost in the surface it lies on.
  void add_line(const ScreenPoint& a, const ScreenPoint& b, double width, double slack);

  /// Returns whether nothing lies in front of a point.
  bool sees(const ScreenPoint& p, double slack) const;

  /// Returns the number of samples in a row.
  int columns() const { return columns_; }
  /// Returns the number of samples in a column.
  int rows() const { return rows_; }
  /// Returns the number of the triangle that is seen at a sample, or `nothing` or `line`.
  int at(int column, int row) const { return number_[index(column, row)]; }

 private:
  std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
           static_cast<std::size_t>(column);
  }
  void add_short_line(const ScreenPoint& a, const ScreenPoint& b, double width, double slack);

  int columns_, rows_;
  std::vector<int> number_;
  std::vector<float> nearness_;
};

}  // namespace isostretch::figures
