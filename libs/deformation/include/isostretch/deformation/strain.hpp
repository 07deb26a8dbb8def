#pragma once

#include <isostretch/assembly/elements.hpp>
#include <isostretch/assembly/energy_assembler.hpp>
#include <isostretch/core/vector.hpp>

#include <vector>

namespace isostretch::deformation {

/// How a body is strained at some positions: what pictures and reports show, for any energy.
struct StrainField {
  std::vector<double> stretches;      ///< [element][point][dim]: singular values of F, the last signed
  std::vector<double> min_det;        ///< of every element over its quadrature points: det F
  std::vector<double> length_change;  ///< the same: largest factor by which a length changes, at least 1
  std::vector<int> inverted;          ///< elements with det F <= 0 somewhere, or NaN

  double smallest_det() const;
  int worst_element() const;  ///< where
};

class Strain {
 public:
  /// The elements must live longer.
  explicit Strain(const assembly::Elements& elements);
  StrainField at(const Vector& positions) const;

 private:
  const assembly::Elements& elements_;
  assembly::EnergyAssembler assembler_;
};

}  // namespace isostretch::deformation
