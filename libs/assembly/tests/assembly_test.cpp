// Energy, gradient and Hessian that are assembled, against dense algebra and differences.
#include "every_level.hpp"
#include "positions.hpp"

#include <isostretch/assembly/energy_assembler.hpp>
#include <isostretch/energies/registry.hpp>
#include <isostretch/fem/elements.hpp>
#include <isostretch/fem/quadratic.hpp>
#include <isostretch/mesh/generators.hpp>
#include <isostretch/mesh/structured.hpp>
#include <isostretch/projection/projection.hpp>

#include <doctest/doctest.h>
#include <omp.h>

#include <Eigen/Dense>

#include <algorithm>
#include <random>
#include <utility>
#include <vector>

using namespace isostretch;
using namespace isostretch::tests;
using assembly::Elements;
using assembly::EnergyAssembler;
using projection::Filter;

namespace {

struct Assembled {
  double value;
  Eigen::VectorXd gradient;
  Eigen::MatrixXd hessian;  // dense, full
  std::vector<double> raw;
};

Assembled assemble(const Elements& elements, const energies::AnyEnergy& energy, const Eigen::VectorXd& x,
                   projection::FilterOptions filter, const std::vector<bool>& pinned = {}) {
  EnergyAssembler assembler(elements, energy);
  assembly::PatternBuilder builder(elements.node_count);
  assembler.add_stencil(builder);
  const assembly::HessianPattern pattern(assembly::FreeUnknowns(elements.dim, elements.node_count, pinned),
                                         std::move(builder));
  assembler.set_pattern(pattern);
  Assembled result;
  result.gradient.setZero(x.size());
  result.value = assembler.differentiate(x.data(), filter, result.gradient.data(), true).value;
  sparse::SymmetricMatrix matrix = pattern.zero_matrix();
  matrix.validate();
  assembler.add_hessian(matrix.value.data());
  result.raw = matrix.value;
  result.hessian.setZero(matrix.size, matrix.size);
  for (int j = 0; j < matrix.size; ++j)
    for (int k = matrix.column_start[static_cast<std::size_t>(j)];
         k < matrix.column_start[static_cast<std::size_t>(j) + 1]; ++k) {
      const int i = matrix.row[static_cast<std::size_t>(k)];
      result.hessian(i, j) = result.hessian(j, i) = matrix.value[static_cast<std::size_t>(k)];
    }
  CHECK(assembler.value(x.data()).value == doctest::Approx(result.value).epsilon(1e-13));
  return result;
}

// Element by element with the single-point interface and dense matrices.
template <int Dim>
Assembled reference(const Elements& e, const energies::AnyEnergy& energy, const Eigen::VectorXd& x,
                    projection::FilterOptions filter) {
  Assembled result{0, Eigen::VectorXd::Zero(x.size()), Eigen::MatrixXd::Zero(x.size(), x.size()), {}};
  const int n = e.nodes_per_element;
  for (int t = 0; t < e.element_count(); ++t)
    for (int p = 0; p < e.points_per_element; ++p) {
      const int point = t * e.points_per_element + p;
      Eigen::MatrixXd B = Eigen::Map<const Eigen::MatrixXd>(e.gradients.data() + point * n * Dim, Dim, n);
      Eigen::MatrixXd X(Dim, n), D = Eigen::MatrixXd::Zero(Dim * Dim, x.size());
      for (int a = 0; a < n; ++a) {
        const int node = e.nodes[static_cast<std::size_t>(t * n + a)];
        X.col(a) = x.segment(Dim * node, Dim);
        for (int r = 0; r < Dim; ++r)
          for (int c = 0; c < Dim; ++c) D(r + Dim * c, Dim * node + r) += B(c, a);
      }
      const Eigen::Matrix<double, Dim, Dim> F = X * B.transpose();
      const auto at = projection::evaluate<Dim>(energy, F, filter);
      const double w = e.weights[static_cast<std::size_t>(point)];
      result.value += w * at.psi;
      result.gradient += w * D.transpose() * Eigen::Map<const Eigen::VectorXd>(at.P.data(), Dim * Dim);
      result.hessian += w * D.transpose() * at.H * D;
    }
  return result;
}

template <int Dim>
void check_against_reference(const Elements& elements, const Eigen::VectorXd& x) {
  int checked = 0;
  for (const auto& name : energies::energy_names()) {
    const auto energy = energies::make_energy(name);
    if (!energy.supports(Dim)) continue;
    ++checked;
    CAPTURE(name);
    for (const auto filter : {projection::Filter::none, projection::Filter::clamp, projection::Filter::abs}) {
      const auto ours = assemble(elements, energy, x, {filter});
      const auto expected = reference<Dim>(elements, energy, x, {filter});
      CHECK(ours.value == doctest::Approx(expected.value).epsilon(1e-12));
      CHECK((ours.gradient - expected.gradient).norm() <= 1e-12 * (1 + expected.gradient.norm()));
      CHECK((ours.hessian - expected.hessian).norm() <= 1e-12 * (1 + expected.hessian.norm()));
    }
  }
  CHECK(checked > 10);
}

}  // namespace

TEST_CASE(
    "energy, gradient and filtered Hessian equal dense element-by-element assembly, every energy and level") {
  at_every_level([] {
    check_against_reference<2>(triangles(3), planar_positions(3, 0.05, 1));
    check_against_reference<3>(tets(), solid_positions(0.05, 2));
  });
}

TEST_CASE("only elements with a marked node are filtered") {
  at_every_level([] {
    const auto elements = tets();
    const auto energy = energies::make_energy("stable_neo_hookean");
    const Eigen::VectorXd x = solid_positions(0.4, 2);  // far from rest: indefinite nearly everywhere
    const auto hessian = [&](Filter filter, const unsigned char* nodes) {
      return assemble(elements, energy, x, {filter, 0.0, 1.0, nodes}).hessian;
    };
    std::vector<unsigned char> marked(static_cast<std::size_t>(elements.node_count), 0);
    const auto exact = hessian(Filter::none, nullptr), clamped = hessian(Filter::clamp, nullptr);
    REQUIRE((clamped - exact).norm() > 1e-3 * exact.norm());
    CHECK(hessian(Filter::clamp, marked.data()) == exact);
    marked[0] = 1;
    // Two nodes that share no element with node 0 are coupled as in the exact Hessian.
    const auto partly = hessian(Filter::clamp, marked.data());
    CHECK(partly.topLeftCorner(3, 3) == clamped.topLeftCorner(3, 3));
    CHECK(partly.bottomRightCorner(3, 3) == exact.bottomRightCorner(3, 3));
    std::fill(marked.begin(), marked.end(), static_cast<unsigned char>(1));
    CHECK(hessian(Filter::clamp, marked.data()) == clamped);
  });
}

TEST_CASE("elements of more nodes and points equal dense element-by-element assembly") {
  const auto moved = [](const auto& nodes) {
    std::mt19937 generator(7);
    std::uniform_real_distribution<double> uniform(-0.03, 0.03);
    Eigen::VectorXd x(nodes.size());
    for (Eigen::Index i = 0; i < x.size(); ++i) x[i] = 1.2 * nodes.data()[i] + uniform(generator);
    return x;
  };
  const mesh::SurfaceMesh grid = mesh::grid(2, 2);
  const auto quads = mesh::quad_grid(3, 2);
  const auto curved = mesh::quadratic(mesh::Points2(grid.vertices.leftCols<2>()), grid.triangles);
  const auto hexes = mesh::hex_bar(2, 1, 1);
  const auto tets = mesh::quadratic(mesh::tet_bar(1, 1, 1));
  at_every_level([&] {
    check_against_reference<2>(assembly::elements_from(mesh::elements(quads)), moved(quads.vertices));
    check_against_reference<2>(assembly::elements_from(mesh::elements(curved)), moved(curved.nodes));
    check_against_reference<3>(assembly::elements_from(mesh::elements(hexes)), moved(hexes.vertices));
    check_against_reference<3>(assembly::elements_from(mesh::elements(tets)), moved(tets.nodes));
  });
}

TEST_CASE("gradient and Hessian against differences of the assembled energy and gradient") {
  const Elements elements = triangles(4);
  const auto energy = energies::make_energy("symmetric_dirichlet");
  const Eigen::VectorXd x = planar_positions(4, 0.02, 5);
  const auto at = assemble(elements, energy, x, {projection::Filter::none});
  EnergyAssembler assembler(elements, energy);
  for (Eigen::Index i = 0; i < x.size(); i += 7) {
    const double h = 1e-6;
    Eigen::VectorXd plus = x, minus = x;
    plus[i] += h;
    minus[i] -= h;
    CHECK((assembler.value(plus.data()).value - assembler.value(minus.data()).value) / (2 * h) ==
          doctest::Approx(at.gradient[i]).epsilon(1e-6));
    Eigen::VectorXd up = Eigen::VectorXd::Zero(x.size()), down = up;
    assembler.differentiate(plus.data(), {}, up.data(), false);
    assembler.differentiate(minus.data(), {}, down.data(), false);
    CHECK(((up - down) / (2 * h) - at.hessian.col(i)).norm() <= 1e-5 * at.hessian.norm());
  }
}

TEST_CASE("results are the same bit for bit for any number of threads") {
  at_every_level([] {
    const Elements elements = triangles(30);
    const auto energy = energies::make_energy("symmetric_dirichlet");
    const Eigen::VectorXd x = planar_positions(30, 0.002, 3);
    const int before = omp_get_max_threads();
    omp_set_num_threads(1);
    const auto one = assemble(elements, energy, x, {});
    for (const int threads : {2, 3, 7}) {
      omp_set_num_threads(threads);
      const auto many = assemble(elements, energy, x, {});
      CHECK(many.value == one.value);
      CHECK((many.gradient.array() == one.gradient.array()).all());
      CHECK(many.raw == one.raw);
    }
    omp_set_num_threads(before);
  });
}

TEST_CASE("pinned degrees of freedom are eliminated from the matrix and nothing else changes") {
  const Elements elements = triangles(3);
  const auto energy = energies::make_energy("arap");
  const Eigen::VectorXd x = planar_positions(3, 0.05, 8);
  std::vector<bool> pinned(static_cast<std::size_t>(x.size()), false);
  for (const std::size_t dof : {0u, 1u, 7u, 20u}) pinned[dof] = true;
  const auto all = assemble(elements, energy, x, {});
  const auto some = assemble(elements, energy, x, {}, pinned);
  const assembly::FreeUnknowns unknowns(2, elements.node_count, pinned);
  REQUIRE(some.hessian.rows() == x.size() - 4);
  for (int i = 0; i < unknowns.size(); ++i)
    for (int j = 0; j < unknowns.size(); ++j)
      CHECK(some.hessian(i, j) == all.hessian(unknowns.dof(i), unknowns.dof(j)));
}

TEST_CASE("translations cost nothing: the Hessian's rows add up to zero") {
  const Elements elements = tets();
  const auto H =
      assemble(elements, energies::make_energy("stable_neo_hookean"), solid_positions(0.1, 4), {}).hessian;
  Eigen::VectorXd shift = Eigen::VectorXd::Zero(H.rows());
  for (Eigen::Index i = 0; i < shift.size(); i += 3) shift[i] = 1;
  CHECK((H * shift).norm() <= 1e-13 * H.norm());
}

TEST_CASE("several quadrature points add up") {
  Elements once = triangles(3);
  Elements twice = once;
  twice.points_per_element = 2;
  twice.gradients.clear();
  twice.weights.clear();
  for (int t = 0; t < once.element_count(); ++t)
    for (int p = 0; p < 2; ++p) {
      twice.gradients.insert(twice.gradients.end(), once.gradients.begin() + 6 * t,
                             once.gradients.begin() + 6 * t + 6);
      twice.weights.push_back(0.5 * once.weights[static_cast<std::size_t>(t)]);
    }
  const Eigen::VectorXd x = planar_positions(3, 0.05, 12);
  const auto energy = energies::make_energy("symmetric_arap");
  const auto a = assemble(once, energy, x, {}), b = assemble(twice, energy, x, {});
  CHECK(a.value == doctest::Approx(b.value).epsilon(1e-14));
  CHECK((a.gradient - b.gradient).norm() <= 1e-13 * a.gradient.norm());
  CHECK((a.hessian - b.hessian).norm() <= 1e-13 * a.hessian.norm());
}
