#pragma once

#include <isostretch/figures/canvas.hpp>
#include <isostretch/inspection/study.hpp>

#include <cstddef>
#include <string>
#include <vector>

namespace isostretch::figures {

/// Values at the points of a square lattice, the first stretch along rows; NaN outside of the domain.
class Lattice {
 public:
  /// Makes a lattice of zeros with that many points a side.
  explicit Lattice(std::size_t points) : points_(points), values_(points * points) {}

  /// Returns the number of points a side.
  std::size_t points() const { return points_; }
  /// Returns the value at point i of row j.
  double& at(std::size_t i, std::size_t j) { return values_[j * points_ + i]; }
  /// Returns the value at point i of row j.
  double at(std::size_t i, std::size_t j) const { return values_[j * points_ + i]; }
  /// Returns the value between the points, interpolated; x and y go from 0 to 1.
  double between(double x, double y) const;
  /// Returns all values, row by row.
  const std::vector<double>& values() const { return values_; }

 private:
  std::size_t points_;
  std::vector<double> values_;
};

/// Maps of an energy: psi and the smallest eigenvalue of its Hessian over the stretches (s1, s2) of a range,
/// in space with s3 = 1, side by side.
class EnergyMaps {
 public:
  /// Evaluates the energy, which must exist in that dimension.
  EnergyMaps(const energies::AnyEnergy& energy, int dim, const inspection::StretchRange& range);

  /// Returns the bytes of the picture.
  std::string draw(PictureFormat format) const;

 private:
  std::string title_;
  int dim_;
  inspection::StretchRange range_;
  Lattice psi_, eigenvalue_;
};

}  // namespace isostretch::figures
