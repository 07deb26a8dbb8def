#pragma once

#include "options.hpp"

#include <isostretch/energies/any_energy.hpp>
#include <isostretch/figures/canvas.hpp>

#include <cstddef>
#include <string>
#include <vector>

namespace isostretch::app::inspect {

// Values at the points of a square lattice, s1 along rows; NaN outside of the domain.
class Field {
 public:
  explicit Field(std::size_t points) : points_(points), values_(points * points) {}

  std::size_t points() const { return points_; }
  double& at(std::size_t i, std::size_t j) { return values_[j * points_ + i]; }
  double at(std::size_t i, std::size_t j) const { return values_[j * points_ + i]; }
  // Between the points, x and y from 0 to 1.
  double between(double x, double y) const;
  const std::vector<double>& values() const { return values_; }

 private:
  std::size_t points_;
  std::vector<double> values_;
};

// psi and the smallest eigenvalue of its Hessian over the stretches (s1, s2) of a range, in space with s3 =
// 1, side by side.
class Maps {
 public:
  Maps(const energies::AnyEnergy& energy, int dim, const Range& range);

  std::string draw(figures::PictureFormat format) const;

 private:
  std::string title_;
  int dim_;
  Range range_;
  Field psi_, eigenvalue_;
};

}  // namespace isostretch::app::inspect
