#include <isostretch/assembly/deformation_operator.hpp>
#include <isostretch/deformation/strain.hpp>
#include <isostretch/energies/registry.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace isostretch::deformation {

double StrainField::smallest_det() const {
  return min_det[static_cast<std::size_t>(worst_element())];
}

int StrainField::worst_element() const {
  return static_cast<int>(std::min_element(min_det.begin(), min_det.end()) - min_det.begin());
}

Strain::Strain(const assembly::Elements& elements)
    : elements_(elements), assembler_(elements, energies::make_energy("arap")) {}

StrainField Strain::at(const Vector& positions) const {
  const assembly::Elements& e = elements_;
  const auto points = static_cast<std::size_t>(e.points_per_element), dim = static_cast<std::size_t>(e.dim);
  const auto count = static_cast<std::size_t>(e.element_count());
  StrainField field;
  field.stretches = assembler_.stretches(positions.data());
  const std::vector<double> determinants = assembly::determinants(e, positions.data());
  field.min_det.assign(count, std::numeric_limits<double>::infinity());
  field.length_change.assign(count, 1.0);
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t p = 0; p < points; ++p) {
      const double* sigma = field.stretches.data() + (i * points + p) * dim;
      field.min_det[i] = std::min(field.min_det[i], determinants[i * points + p]);
      field.length_change[i] = std::max({field.length_change[i], sigma[0], 1 / std::abs(sigma[dim - 1])});
    }
    if (!(field.min_det[i] > 0)) field.inverted.push_back(static_cast<int>(i));
  }
  return field;
}

}  // namespace isostretch::deformation
