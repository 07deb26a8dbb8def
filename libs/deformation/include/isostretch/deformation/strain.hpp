#pragma once

#include <isostretch/assembly/elements.hpp>
#include <isostretch/assembly/energy_assembler.hpp>
#include <isostretch/core/vector.hpp>

#include <vector>

namespace isostretch::deformation {

/// The strain of a body at some positions, as pictures and reports show it for any energy.
struct StrainField {
  std::vector<double> stretches;  ///< Singular values of F, [element][point][dim], the last signed.
  std::vector<double> min_det;    ///< Least det F of every element over its quadrature points.
  /// Largest factor by which a length changes, at least 1, of every element over its quadrature points.
  std::vector<double> length_change;
  std::vector<int> inverted;  ///< Elements with det F <= 0 somewhere, or NaN.

  /// Returns the smallest determinant of all elements.
  double smallest_det() const;
  int worst_element() const;  ///< Returns the element of the smallest determinant.
};

/// A computation of the strain of elements at any positions.
class Strain {
 public:
  /// Prepares the computation; the elements must outlive this object.
  explicit Strain(const assembly::Elements& elements);
  /// Returns the strain at positions, dim entries per node.
  StrainField at(const Vector& positions) const;

 private:
  const assembly::Elements& elements_;
  assembly::EnergyAssembler assembler_;
};

}  // namespace isostretch::deformation
