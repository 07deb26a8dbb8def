#pragma once

// What the tests of methods for distortion energies share: a cap to flatten and a bar to bend, as problems.
#include <isostretch/baselines/distortion.hpp>
#include <isostretch/energies/registry.hpp>
#include <isostretch/fem/element_arrays.hpp>
#include <isostretch/mesh/generators.hpp>
#include <isostretch/parameterization/tutte.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <utility>
#include <vector>

namespace isostretch::tests {

struct Started {
  baselines::DistortionProblem problem;
  Vector start;
};

// A head-like cap of that many rings, of total area 1, to be flattened from Tutte's embedding of area 1.
inline Started flattening(const energies::AnyEnergy& energy, int rings = 12) {
  const mesh::SurfaceMesh surface = mesh::procedural_face(rings);
  auto arrays = mesh::flat_elements(surface);
  mesh::scale_to_total_weight(arrays);
  const auto tutte = parameterization::tutte_embedding(surface);
  REQUIRE(tutte.status == parameterization::TutteStatus::ok);
  return {{assembly::elements_from(arrays), energy, {}},
          Eigen::Map<const Vector>(tutte.uv.data(), tutte.uv.size())};
}

// A bar of total volume 1 along x, held at one end; the other end is held too, twisted by `turn` about the
// axis, and what lies between starts at the share of the twist that its place says.
inline Started twisted_bar(const energies::AnyEnergy& energy, double turn = 1.2) {
  const mesh::TetMesh bar = mesh::tet_bar(6, 2, 2, 3, 1, 1);
  auto arrays = mesh::elements(bar);
  mesh::scale_to_total_weight(arrays);
  Started started{{assembly::elements_from(arrays), energy, {}}, {}};
  const mesh::Points3& points = bar.vertices;
  started.start.resize(3 * points.rows());
  const double longest = points.col(0).maxCoeff();
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    const double share = points(i, 0) / longest, c = std::cos(turn * share), s = std::sin(turn * share);
    const double y = points(i, 1) - 0.5, z = points(i, 2) - 0.5;
    started.start.segment<3>(3 * i) << points(i, 0), c * y - s * z, s * y + c * z;
    if (share == 0 || share == 1) started.problem.pinned.push_back(static_cast<int>(i));
  }
  return started;
}

}  // namespace isostretch::tests
