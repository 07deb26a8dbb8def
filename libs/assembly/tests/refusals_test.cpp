// Elements, places and energies that the assembler cannot use, and what it says of them.
#include "positions.hpp"

#include <isostretch/assembly/energy_assembler.hpp>
#include <isostretch/core/error.hpp>
#include <isostretch/energies/registry.hpp>

#include <doctest/doctest.h>
#include <omp.h>

#include <Eigen/Core>

#include <cmath>
#include <stdexcept>
#include <string>
#include <type_traits>

using namespace isostretch;
using namespace isostretch::tests;
using assembly::Elements;
using assembly::EnergyAssembler;

namespace {

// Throws at the elements that are larger than a limit, once it is armed.
struct Throwing {
  static constexpr const char* name = "throwing";
  inline static double largest_psi = 1e300;

  template <int Dim, class T>
  T psi(const energies::Invariants<Dim, T>& I) const {
    if constexpr (std::is_same_v<T, Pack>) {
      double value[lanes];
      store(value, I.I2);
      for (const double v : value) refuse(v);
    } else {
      if (largest_psi == 0) refuse(1);  // jets
    }
    return I.I2;
  }

  static void refuse(double I2) {
    if (I2 > largest_psi) throw std::out_of_range(std::to_string(I2));
  }
};

}  // namespace

TEST_CASE("an element outside the domain makes the value infinite and is named") {
  const Elements elements = triangles(3);
  EnergyAssembler assembler(elements, energies::make_energy("symmetric_dirichlet"));
  Eigen::VectorXd x = planar_positions(3, 0.0, 1);
  const int element = 11;
  // Mirror one corner of the element through its opposite edge.
  const int* node = elements.nodes.data() + 3 * element;
  const Eigen::Vector2d a = x.segment<2>(2 * node[0]), b = x.segment<2>(2 * node[1]),
                        c = x.segment<2>(2 * node[2]);
  const Eigen::Vector2d t = (c - b).normalized();
  x.segment<2>(2 * node[0]) = b + 2 * t * t.dot(a - b) - (a - b);
  const auto at = assembler.value(x.data());
  CHECK(std::isinf(at.value));
  CHECK(at.worst_element >= 0);
  Eigen::VectorXd gradient = Eigen::VectorXd::Zero(x.size());
  const auto derivative = assembler.differentiate(x.data(), {}, gradient.data(), true);
  CHECK(std::isinf(derivative.value));
  CHECK(derivative.worst_element == at.worst_element);
  CHECK(gradient.isZero(0));
}

TEST_CASE("malformed elements are refused, naming the element") {
  const auto energy = energies::make_energy("arap");
  Elements elements = triangles(2);
  Elements none = elements;
  none.nodes.clear(), none.gradients.clear(), none.weights.clear();
  CHECK_THROWS_WITH_AS(EnergyAssembler(none, energy), doctest::Contains("no elements"), Error);
  elements.nodes[7] = 99;
  CHECK_THROWS_WITH_AS(EnergyAssembler(elements, energy), doctest::Contains("element 2: node 99"), Error);
  Elements five = elements;
  five.nodes_per_element = 5;
  CHECK_THROWS_WITH_AS(EnergyAssembler(five, energy), doctest::Contains("3, 4 and 6 in 2D"), Error);
  elements = triangles(2);
  elements.weights[3] = -1;
  CHECK_THROWS_WITH_AS(EnergyAssembler(elements, energy), doctest::Contains("element 3"), Error);
  elements = triangles(2);
  elements.gradients[6 * 4] += 1;
  CHECK_THROWS_WITH_AS(EnergyAssembler(elements, energy), doctest::Contains("element 4: gradients"), Error);
  elements = triangles(2);
  elements.gradients[6 * 5 + 1] = std::nan("");
  CHECK_THROWS_WITH_AS(EnergyAssembler(elements, energy), doctest::Contains("element 5"), Error);
  CHECK_THROWS_WITH_AS(EnergyAssembler(triangles(2), energies::make_energy("mips_3d")),
                       doctest::Contains("mips_3d"), Error);
}

TEST_CASE("what an energy throws reaches the caller, the same for any number of threads") {
  const int threads_before = omp_get_max_threads();
  const Elements elements = triangles(40);
  EnergyAssembler assembler(elements, Throwing{});
  Eigen::VectorXd x = planar_positions(40, 1e-3, 5);
  Eigen::VectorXd gradient = Eigen::VectorXd::Zero(x.size());
  Throwing::largest_psi = 3.38;  // a few elements of many chunks exceed it
  std::string first;
  for (const int threads : {1, 2, 3, 8}) {
    omp_set_num_threads(threads);
    for (int repeat = 0; repeat < 5; ++repeat) {
      std::string thrown;
      try {
        assembler.value(x.data());
      } catch (const std::out_of_range& error) {
        thrown = error.what();
      }
      CHECK_FALSE(thrown.empty());
      if (first.empty()) first = thrown;
      CHECK(thrown == first);
    }
  }
  Throwing::largest_psi = 0;
  CHECK_THROWS_AS(assembler.value(x.data()), std::out_of_range);
  CHECK_THROWS_AS(assembler.differentiate(x.data(), {}, gradient.data(), true), std::out_of_range);
  Throwing::largest_psi = 1e300;
  CHECK(assembler.value(x.data()).value > 0);
  omp_set_num_threads(threads_before);
}

TEST_CASE("an element whose derivatives are not finite is named") {
  const Elements elements = triangles(12);
  EnergyAssembler assembler(elements, energies::make_energy("symmetric_dirichlet"));
  Eigen::VectorXd x = planar_positions(12, 1e-3, 5);
  Eigen::VectorXd gradient = Eigen::VectorXd::Zero(x.size());
  assembler.differentiate(x.data(), {}, gradient.data(), true);
  CHECK(assembler.element_not_finite() == -1);
  assembler.element_hessians()[assembler.hessian_entries_per_element() * 77 + 3] = std::nan("");
  CHECK(assembler.element_not_finite() == assembler.element_order()[77]);
}
