// What the assembler says of a deformation: stretches, and the step at which the first element vanishes.
#include "every_level.hpp"
#include "positions.hpp"

#include <isostretch/assembly/energy_assembler.hpp>
#include <isostretch/energies/registry.hpp>

#include <doctest/doctest.h>

#include <Eigen/Dense>

#include <cmath>
#include <random>

using namespace isostretch;
using namespace isostretch::tests;
using assembly::Elements;
using assembly::EnergyAssembler;

TEST_CASE("max_step stops where the first determinant vanishes, in 2D and 3D") {
  at_every_level([] {
    const Elements elements = triangles(4);
    EnergyAssembler assembler(elements, energies::make_energy("symmetric_dirichlet"));
    std::mt19937 generator(6);
    std::normal_distribution<double> normal;
    for (int trial = 0; trial < 20; ++trial) {
      const Eigen::VectorXd x = planar_positions(4, 0.02, static_cast<unsigned>(trial));
      const Eigen::VectorXd d = Eigen::VectorXd::NullaryExpr(x.size(), [&] { return normal(generator); });
      const double step = assembler.max_step(x.data(), d.data(), 100);
      REQUIRE(step < 100);
      const Eigen::VectorXd inside = x + 0.999999 * step * d, outside = x + 1.000001 * step * d;
      CHECK(std::isfinite(assembler.value(inside.data()).value));
      CHECK(std::isinf(assembler.value(outside.data()).value));
      CHECK(assembler.max_step(x.data(), d.data(), 0.5 * step) == 0.5 * step);
    }
    const Elements solid = tets();
    EnergyAssembler volume(solid, energies::make_energy("symmetric_dirichlet"));
    for (int trial = 0; trial < 20; ++trial) {
      const Eigen::VectorXd x = solid_positions(0.02, static_cast<unsigned>(trial));
      const Eigen::VectorXd d = Eigen::VectorXd::NullaryExpr(x.size(), [&] { return normal(generator); });
      const double step = volume.max_step(x.data(), d.data(), 100);
      REQUIRE(step < 100);
      const Eigen::VectorXd inside = x + 0.999999 * step * d, outside = x + 1.000001 * step * d;
      CHECK(std::isfinite(volume.value(inside.data()).value));
      CHECK(std::isinf(volume.value(outside.data()).value));
    }
    EnergyAssembler free(elements, energies::make_energy("arap"));
    const Eigen::VectorXd x = planar_positions(4, 0.02, 1);
    CHECK(free.max_step(x.data(), x.data(), 7.0) == 7.0);
  });
}

TEST_CASE("stretches come back in the caller's order of elements") {
  const Elements elements = triangles(5);
  EnergyAssembler assembler(elements, energies::make_energy("arap"));
  const Eigen::VectorXd x = planar_positions(5, 0.05, 9);
  const auto sigma = assembler.stretches(x.data());
  for (int t = 0; t < elements.element_count(); ++t) {
    Eigen::Matrix2d F = Eigen::Matrix2d::Zero();
    for (int a = 0; a < 3; ++a)
      F += x.segment<2>(2 * elements.nodes[static_cast<std::size_t>(3 * t + a)]) *
           Eigen::Map<const Eigen::RowVector2d>(elements.gradients.data() + 6 * t + 2 * a);
    CHECK(sigma[static_cast<std::size_t>(2 * t)] * sigma[static_cast<std::size_t>(2 * t + 1)] ==
          doctest::Approx(F.determinant()).epsilon(1e-10));
  }
}
