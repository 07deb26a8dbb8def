#pragma once

#include <isostretch/figures/camera.hpp>

#include <vector>

namespace isostretch::figures {

/// What is seen at every sample of a picture: the nearest triangle, by its number. Colours are computed
/// afterwards, once a sample, however many triangles lie behind each other.
class Visibility {
 public:
  static constexpr int nothing = -1, line = -2;

  Visibility(int columns, int rows);

  /// Corners in samples. After all triangles, lines: `slack` is how much nearer, as a share, a line counts
  /// than it is, so that it is not lost in the surface it lies on.
  void add_triangle(int number, const ScreenPoint& a, const ScreenPoint& b, const ScreenPoint& c);
  void add_line(const ScreenPoint& a, const ScreenPoint& b, double width, double slack);

  /// Whether nothing lies in front of a point.
  bool sees(const ScreenPoint& p, double slack) const;

  int columns() const { return columns_; }
  int rows() const { return rows_; }
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
