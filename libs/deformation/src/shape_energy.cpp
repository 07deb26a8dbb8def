#include <isostretch/core/error.hpp>
#include <isostretch/deformation/shape_energy.hpp>

#include <algorithm>
#include <cmath>

namespace isostretch::deformation {
namespace {

template <int Dim>
energies::StretchDerivatives<Dim, double> derivatives_at_rest(const energies::AnyEnergy& energy) {
  invariants::PrincipalStretches<Dim, double> rest;
  std::fill(std::begin(rest.sigma), std::end(rest.sigma), 1.0);
  return energies::derivatives_at<Dim>(energy, rest);
}

// Slope along a stretch, over the curvature.
template <int Dim>
double slope_at_rest(const energies::AnyEnergy& energy) {
  const auto d = derivatives_at_rest<Dim>(energy);
  return std::abs(d.gradient[0]) / std::max(std::abs(d.diagonal[0]), 1e-300);
}

double density_at_rest(const energies::AnyEnergy& energy, int dim) {
  return dim == 2 ? derivatives_at_rest<2>(energy).psi : derivatives_at_rest<3>(energy).psi;
}

}  // namespace

void require_least_at_rest(const energies::AnyEnergy& energy, int dim) {
  const double slope = dim == 2 ? slope_at_rest<2>(energy) : slope_at_rest<3>(energy);
  if (slope > 1e-6)
    throw Error(
        "'" + energy.name() +
        "' with these parameters is not at its minimum at rest: interpolation would not begin and end "
        "at the poses");
}

ShapeEnergy::ShapeEnergy(const KeyShapes& key_shapes, const energies::AnyEnergy& energy,
                         const std::vector<int>& held)
    : objective_(key_shapes.first.dim, static_cast<int>(key_shapes.first.nodes.rows())),
      terms_{&objective_.add<newton::EnergyTerm>(key_shapes.first.elements, energy),
             &objective_.add<newton::EnergyTerm>(key_shapes.second.elements, energy)} {
  const double density = density_at_rest(energy, key_shapes.first.dim);
  at_rest_ = {density * key_shapes.first.volume(), density * key_shapes.second.volume()};
  for (const int node : held) objective_.pin(node);
}

void ShapeEnergy::set_time(double t) {
  time_ = t;
  terms_[0]->set_scale(1 - t);
  terms_[1]->set_scale(t);
}

std::array<double, 2> ShapeEnergy::parts(const Vector& positions) {
  std::array<double, 2> result;
  for (std::size_t i = 0; i < 2; ++i) {
    terms_[i]->set_scale(1);  // 0 would leave it out
    result[i] = terms_[i]->value(positions).value - at_rest_[i];
  }
  set_time(time_);
  return result;
}

}  // namespace isostretch::deformation
