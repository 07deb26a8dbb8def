#pragma once

#include <isostretch/fem/element_arrays.hpp>
#include <isostretch/mesh/types.hpp>

namespace isostretch::parameterization {

// sum of weight (|F|^2 + |F^-1|^2) over the triangles, symmetric Dirichlet energy with minimum 4 times the
// total weight; infinite when a triangle is flipped or collapsed.
double stretch_energy(const mesh::ElementArrays& rest, const mesh::Points2& uv);

// Applies to uv the linear map, a stretch along two perpendicular directions, that makes this energy
// smallest. Long narrow charts need it: Tutte's embedding makes them as wide as long.
void fit_affinely(const mesh::ElementArrays& rest, mesh::Points2& uv);

}  // namespace isostretch::parameterization
