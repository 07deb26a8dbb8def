#include <isostretch/core/error.hpp>
#include <isostretch/energies/registry.hpp>
#include <isostretch/mesh/element_arrays.hpp>
#include <isostretch/mesh/generators.hpp>
#include <isostretch/newton/objective.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

using namespace isostretch;

namespace {

assembly::Elements grid_elements(int n) {
  return assembly::elements_from(mesh::flat_elements(mesh::grid(n, n)));
}

Vector grid_positions(int n) {
  const auto vertices = mesh::grid(n, n).vertices;
  Vector x(2 * vertices.rows());
  for (Eigen::Index i = 0; i < vertices.rows(); ++i) x.segment<2>(2 * i) = vertices.row(i).head<2>();
  return x;
}

}  // namespace

TEST_CASE("an objective is the sum of its terms, gradient and Hessian included") {
  const auto elements = grid_elements(3);
  newton::Objective objective(2, elements.node_count);
  objective.add<newton::EnergyTerm>(elements, energies::make_energy("arap"));
  newton::Objective with_pin(2, elements.node_count);
  with_pin.add<newton::EnergyTerm>(elements, energies::make_energy("arap"));
  with_pin.add<newton::SoftPinTerm>(2, elements.node_count, std::vector<newton::SoftPin>{{5, {3, 4}, 10.0}});
  Vector x = 1.2 * grid_positions(3);
  Vector g0, g1;
  const double e0 = objective.differentiate(x, {}, g0, true).value;
  const double e1 = with_pin.differentiate(x, {}, g1, true).value;
  const Eigen::Vector2d away = x.segment<2>(10) - Eigen::Vector2d(3, 4);
  CHECK(e1 - e0 == doctest::Approx(10 * away.squaredNorm()));
  CHECK((g1 - g0).segment<2>(10).isApprox(20 * away));
  sparse::SymmetricMatrix h0 = objective.pattern().zero_matrix(), h1 = with_pin.pattern().zero_matrix();
  objective.hessian(h0);
  with_pin.hessian(h1);
  const Vector direction = Vector::Unit(x.size(), 11);
  CHECK((h1.multiply(direction) - h0.multiply(direction)).isApprox(20 * direction));
}

TEST_CASE("pins take degrees of freedom out of gradient and matrix") {
  const auto elements = grid_elements(2);
  newton::Objective objective(2, elements.node_count);
  objective.add<newton::EnergyTerm>(elements, energies::make_energy("arap"));
  CHECK_FALSE(objective.has_pins());
  objective.pin(0);
  objective.pin(3, 1);
  CHECK(objective.has_pins());
  CHECK(objective.pattern().zero_matrix().size == objective.dofs() - 3);
  Vector gradient;
  const Vector x = 2 * grid_positions(2);
  objective.differentiate(x, {}, gradient, true);
  CHECK(gradient[0] == 0);
  CHECK(gradient[1] == 0);
  CHECK(gradient[7] == 0);
  CHECK(gradient[6] != 0);
}

TEST_CASE("misuse is refused, naming the node or the pin") {
  newton::Objective objective(2, 4);
  CHECK_THROWS_WITH_AS(objective.pin(4), doctest::Contains("node 4"), Error);
  CHECK_THROWS_WITH_AS(objective.pin(0, 2), doctest::Contains("axis 2"), Error);
  CHECK_THROWS_AS(newton::Objective(4, 4), Error);
  const auto pins = [](newton::SoftPin pin) { return std::vector<newton::SoftPin>{std::move(pin)}; };
  CHECK_THROWS_WITH_AS(newton::SoftPinTerm(2, 4, pins({7, {0, 0}, 1})), doctest::Contains("node 7"), Error);
  CHECK_THROWS_WITH_AS(newton::SoftPinTerm(2, 4, pins({1, {0, 0, 0}, 1})), doctest::Contains("pin 0"), Error);
  CHECK_THROWS_WITH_AS(newton::SoftPinTerm(2, 4, pins({1, {0, std::nan("")}, 1})),
                       doctest::Contains("finite"), Error);
  CHECK_THROWS_WITH_AS(newton::SoftPinTerm(2, 4, pins({1, {0, 0}, -1})), doctest::Contains("weight"), Error);
}
