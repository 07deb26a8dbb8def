#include <isostretch/core/error.hpp>
#include <isostretch/energies/registry.hpp>
#include <isostretch/fem/element_arrays.hpp>
#include <isostretch/fem/elements.hpp>
#include <isostretch/mesh/generators.hpp>
#include <isostretch/newton/minimize.hpp>
#include <isostretch/parameterization/tutte.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

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

TEST_CASE("equality constraints: the Hessian is T^T H T, gradient and direction go through T") {
  const auto elements = grid_elements(3);
  const auto make = [&] {
    newton::Objective objective(2, elements.node_count);
    objective.add<newton::EnergyTerm>(elements, energies::make_energy("symmetric_dirichlet"));
    objective.pin(7);
    return objective;
  };
  newton::Objective free = make(), constrained = make();
  constrained.add_equality(4, 1, 0);  // neighbours: an entry off the diagonal comes to lie on it
  constrained.add_equality(5, 4, 0);
  constrained.add_equality(9, 14, 1);
  constrained.add_equality(7, 2, 1);  // pinned with node 7
  const Vector x = 1.3 * grid_positions(3);
  Vector gradient, reduced;
  sparse::SymmetricMatrix H = free.zero_matrix(), small = constrained.zero_matrix();
  REQUIRE(small.size == free.dofs() - 2 - 1 - 3);
  small.validate();
  free.differentiate(x, {}, gradient, true);
  free.hessian(H);
  constrained.differentiate(x, {}, gradient, true);
  constrained.hessian(small);
  constrained.restrict(gradient, reduced);
  std::mt19937 generator(3);
  std::uniform_real_distribution<double> uniform(-1, 1);
  Vector d(small.size), full, on_free;
  for (double& value : d) value = uniform(generator);
  constrained.extend(d, full);
  CHECK(full[2 * 4] == full[2 * 1]);
  CHECK(full[2 * 5] == full[2 * 1]);
  CHECK(full[2 * 9 + 1] == full[2 * 14 + 1]);
  CHECK(full[2 * 2 + 1] == 0);
  CHECK(full[2 * 7] == 0);
  CHECK(reduced.dot(d) == doctest::Approx(gradient.dot(full)));
  free.restrict(full, on_free);
  CHECK(small.multiply(d).dot(d) == doctest::Approx(H.multiply(on_free).dot(on_free)).epsilon(1e-12));
}

TEST_CASE("equality constraints hold to the bit through a minimisation") {
  const mesh::SurfaceMesh face = mesh::procedural_face(6);
  mesh::ElementArrays rest = mesh::flat_elements(face);
  mesh::scale_to_total_weight(rest, 1.0);
  parameterization::TutteOptions square;
  square.boundary = parameterization::BoundaryShape::square;
  const mesh::Points2 uv = parameterization::tutte_embedding(face, square).uv;
  newton::Objective free(2, rest.node_count), constrained(2, rest.node_count);
  for (newton::Objective* objective : {&free, &constrained})
    objective->add<newton::EnergyTerm>(assembly::elements_from(rest),
                                       energies::make_energy("symmetric_dirichlet"));
  std::vector<int> bottom;
  for (int v = 0; v < rest.node_count; ++v)
    if (uv(v, 1) == -0.5) bottom.push_back(v);
  REQUIRE(bottom.size() > 4);
  for (const int v : bottom) constrained.add_equality(bottom.front(), v, 1);
  const Vector start = Eigen::Map<const Vector>(uv.data(), uv.size());
  Vector x = start, y = start;
  const newton::Summary unconstrained = newton::minimize(free, x),
                        straight = newton::minimize(constrained, y);
  CHECK_MESSAGE(straight.converged(), straight.full_report());
  CHECK(straight.energy > unconstrained.energy);
  for (const int v : bottom) CHECK(y[2 * v + 1] == y[2 * bottom.front() + 1]);
  y[2 * bottom[1] + 1] += 0.5;
  CHECK_THROWS_WITH_AS(newton::minimize(constrained, y),
                       doctest::Contains("are to be equal but start with different"), Error);
  CHECK_THROWS_WITH_AS(constrained.add_equality(0, 9999, 0), "cannot equate axis 0 of node 9999", Error);
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

namespace {

bool table_ends = false;

// psi read from a table that may end.
struct Tabulated {
  static constexpr const char* name = "tabulated";

  template <int Dim, class T>
  T psi(const energies::Invariants<Dim, T>& I) const {
    if (table_ends) throw std::runtime_error("stretch outside of the material table");
    return I.I2 - 2.0 * I.I1;
  }
};

// Finite, with derivatives that are not where the determinant is large.
struct Unbounded {
  static constexpr const char* name = "unbounded";
  static constexpr double minimum_determinant = 0.0;

  template <int Dim, class T>
  T psi(const energies::Invariants<Dim, T>& I) const {
    using isostretch::log;
    return -log(I.I3);
  }
};

newton::Objective objective_of(const assembly::Elements& elements, const energies::AnyEnergy& energy) {
  newton::Objective objective(elements.dim, elements.node_count);
  objective.add<newton::EnergyTerm>(elements, energy);
  return objective;
}

}  // namespace

TEST_CASE("an exception of psi reaches the caller of minimize, with the best positions so far") {
  newton::Objective objective = objective_of(grid_elements(20), Tabulated{});
  const Vector start = 1.5 * grid_positions(20);
  Vector x = start;
  table_ends = true;
  CHECK_THROWS_WITH_AS(newton::minimize(objective, x), "stretch outside of the material table",
                       std::runtime_error);
  CHECK(x == start);
  table_ends = false;
  double energy = 0;
  const auto after_one_step = [&](const newton::Iteration& row, const Vector&) {
    table_ends = row.iteration == 1;
    energy = row.energy;
    return newton::CallbackAction::proceed;
  };
  x += 0.01 * Vector::Random(x.size());
  CHECK_THROWS_AS(newton::minimize(objective, x, {}, after_one_step), std::runtime_error);
  table_ends = false;
  CHECK(objective.value(x).value == energy);
  CHECK(newton::minimize(objective, x).converged());
}

TEST_CASE("derivatives that are not finite end the solve with a status that names the element") {
  newton::Objective objective = objective_of(grid_elements(3), Unbounded{});
  Vector x = grid_positions(3);
  const newton::Summary summary = newton::minimize(objective, x);
  CHECK(newton::failed(summary.status));
  CHECK(x.allFinite());
  CHECK(summary.energy == objective.value(x).value);
  MESSAGE(summary.message);
  Vector huge = 1e160 * grid_positions(3);
  const newton::Summary at_start = newton::minimize(objective, huge);
  CHECK(newton::failed(at_start.status));
  CHECK_MESSAGE(at_start.message.find("element ") != std::string::npos, at_start.message);
}

TEST_CASE("objectives and terms that do not fit are refused where they meet") {
  CHECK_THROWS_WITH_AS(newton::Objective(2, 0), doctest::Contains("objective of 0 nodes"), Error);
  CHECK_THROWS_WITH_AS(newton::Objective(3, -4), doctest::Contains("objective of -4 nodes"), Error);
  CHECK_THROWS_WITH_AS(newton::Objective(3, std::numeric_limits<int>::max() / 2),
                       doctest::Contains("nodes in 3D"), Error);
  const auto flat = grid_elements(2);
  const auto solid = assembly::elements_from(mesh::elements(mesh::tet_bar(1, 1, 1)));
  newton::Objective plane(2, flat.node_count);
  CHECK_THROWS_WITH_AS(plane.add<newton::EnergyTerm>(solid, energies::make_energy("arap")),
                       "an energy term in 3D in an objective in 2D", Error);
  CHECK_THROWS_WITH_AS(plane.add<newton::SoftPinTerm>(3, 4, std::vector<newton::SoftPin>{}),
                       doctest::Contains("soft pins in 3D"), Error);
  newton::Objective small(2, 4);
  CHECK_THROWS_WITH_AS(small.add<newton::EnergyTerm>(flat, energies::make_energy("arap")),
                       "an energy term of 9 nodes in an objective of 4", Error);
  CHECK_THROWS_WITH_AS(small.add_term(nullptr), doctest::Contains("null"), Error);
  Vector x = Vector::Zero(8);
  CHECK_THROWS_WITH_AS(newton::minimize(small, x), doctest::Contains("no terms"), Error);
  assembly::Elements empty;
  empty.dim = 2, empty.nodes_per_element = 3, empty.points_per_element = 1, empty.node_count = 4;
  CHECK_THROWS_WITH_AS(objective_of(empty, energies::make_energy("arap")), doctest::Contains("no elements"),
                       Error);
}

namespace {

struct Concave {
  static constexpr const char* name = "concave";
  template <int Dim, class T>
  T psi(const energies::Invariants<Dim, T>& I) const {
    return -1e-9 * I.I1;
  }
};

}  // namespace

TEST_CASE("a diagonal shift is told in full, however small it is") {
  newton::Objective objective = objective_of(grid_elements(4), Concave{});
  Vector x = grid_positions(4);
  newton::Options options;
  options.max_shifts = 0;
  options.projection = newton::Projection::none;
  const newton::Summary summary = newton::minimize(objective, x, options);
  REQUIRE(summary.status == newton::Status::failed_factorization);
  CHECK_MESSAGE(summary.message.find("0.000000") == std::string::npos, summary.message);
  CHECK(summary.message.find("e-") != std::string::npos);
}
