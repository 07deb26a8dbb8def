// Solid bodies in 3D: recovery from hopeless starts at any stiffness, filters, inexact solves, scaled terms.
#include "conditional.hpp"

#include <isostretch/core/error.hpp>
#include <isostretch/energies/registry.hpp>
#include <isostretch/fem/element_arrays.hpp>
#include <isostretch/mesh/generators.hpp>
#include <isostretch/mesh_io/io.hpp>
#include <isostretch/newton/minimize.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <random>
#include <string>
#include <vector>

using namespace isostretch;
using isostretch::tests::outside_data;
using isostretch::tests::outside_path;
using isostretch::tests::slow_under_sanitizers;
using newton::Projection;

namespace {

struct Body {
  mesh::TetMesh mesh;
  assembly::Elements elements;

  explicit Body(mesh::TetMesh tets) : mesh(std::move(tets)) {
    elements = assembly::elements_from(mesh::elements(mesh));
  }

  Vector rest() const { return Eigen::Map<const Vector>(mesh.vertices.data(), mesh.vertices.size()); }
};

Body bar() {
  return Body(mesh::tet_bar(8, 2, 2, 1.0, 0.25, 0.25));
}

// Hooke's law of Young's modulus and Poisson's ratio at small strain.
energies::AnyEnergy material(const std::string& name, double young, double nu) {
  const double mu = young / (2 * (1 + nu)), lambda = young * nu / ((1 + nu) * (1 - 2 * nu));
  if (name == "arap") return energies::make_energy(name);
  if (name == "corotational") return energies::make_energy(name, {{"mu", mu}, {"kappa", lambda}});
  if (name == "stable_neo_hookean") return energies::make_energy(name, {{"mu", mu}, {"lambda", lambda + mu}});
  return energies::make_energy(name, {{"mu", mu}, {"lambda", lambda}});
}

Vector start(const Body& body, const std::string& kind) {
  Vector x = body.rest();
  std::mt19937 generator(1);
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    if (kind == "random") x[i] = static_cast<double>(generator()) / 4294967296.0;
    if (kind == "point") x[i] = 0.5;
    if (kind == "plane" && i % 3 == 1) x[i] = 0.1;
    if (kind == "mirrored" && i % 3 == 0) x[i] = -x[i];
  }
  return x;
}

double distance_from_rest(const assembly::EnergyAssembler& assembler, const Vector& x) {
  double worst = 0;
  for (const double sigma : assembler.stretches(x.data())) worst = std::max(worst, std::abs(sigma - 1));
  return worst;
}

newton::Options tight() {
  newton::Options options;
  options.scaled_gradient_tolerance = 1e-9;
  return options;
}

struct Relaxed {
  newton::Summary summary;
  double distance;
};

Relaxed relax(const Body& body, const energies::AnyEnergy& energy, Vector& x,
              const newton::Options& options = tight()) {
  newton::Objective objective(3, body.elements.node_count);
  const auto& term = objective.add<newton::EnergyTerm>(body.elements, energy);
  const auto summary = newton::minimize(objective, x, options);
  return {summary, distance_from_rest(term.assembler(), x)};
}

const char* const recovering[] = {"arap", "corotational", "fixed_corotational", "stable_neo_hookean"};
const char* const starts[] = {"random", "point", "plane", "mirrored"};

// A bar whose one end is held and whose other end is moved and turned at once.
struct Bent {
  Body body = bar();
  Vector x;

  newton::Objective objective(const energies::AnyEnergy& energy) {
    newton::Objective result(3, body.elements.node_count);
    result.add<newton::EnergyTerm>(body.elements, energy);
    x = body.rest();
    for (int v = 0; v < body.mesh.vertices.rows(); ++v) {
      const double along = body.mesh.vertices(v, 0);
      if (along < 0.01 || along > 0.99) result.pin(v);
      if (along > 0.99) {
        const double y = x[3 * v + 1], z = x[3 * v + 2];
        x[3 * v] = 1.2;
        x[3 * v + 1] = 0.3 + z;
        x[3 * v + 2] = 0.25 - y;
      }
    }
    return result;
  }
};

}  // namespace

TEST_CASE("a free body comes back to rest from random, collapsed, flattened and mirrored positions") {
  const Body body = bar();
  for (const char* name : recovering)
    for (const char* kind : starts)
      for (const double young : {1.0, 1e9}) {
        CAPTURE(name);
        CAPTURE(kind);
        CAPTURE(young);
        Vector x = start(body, kind);
        const auto relaxed = relax(body, material(name, young, 0.3), x);
        const auto& [summary, distance] = relaxed;
        CAPTURE(relaxed.summary.full_report());
        CHECK(summary.converged());
        // At a point, stable Neo-Hookean has a strict local minimum: its stress vanishes with F, and its
        // Hessian there is mu times the identity.
        if (name == std::string("stable_neo_hookean") && kind == std::string("point"))
          CHECK(summary.iterations == 0);
        else
          CHECK(distance <= 1e-6);
      }
}

TEST_CASE("near incompressibility, ARAP first undoes what would be caught in local minima") {
  const Body body = bar();
  for (const char* name : {"corotational", "fixed_corotational", "stable_neo_hookean"})
    for (const char* kind : starts)
      for (const double nu : {0.49, 0.499})
        for (const double young : {1.0, 1e9}) {
          CAPTURE(name);
          CAPTURE(kind);
          CAPTURE(nu);
          Vector x = start(body, kind);
          CHECK(relax(body, material("arap", 1, 0), x).distance <= 1e-6);
          const auto relaxed = relax(body, material(name, young, nu), x);
          const auto& [summary, distance] = relaxed;
          CAPTURE(relaxed.summary.full_report());
          CHECK(summary.converged());
          CHECK(distance <= 1e-6);
        }
}

TEST_CASE("a body at rest is left there at once, at any stiffness: the energy is nothing but rounding") {
  const Body body = bar();
  for (const char* name : recovering)
    for (const double young : {1e-9, 1.0, 1e9}) {
      CAPTURE(name);
      Vector x = body.rest();
      std::mt19937 generator(3);
      for (Eigen::Index i = 0; i < x.size(); ++i)
        x[i] *= 1 + (generator() % 2 == 0 ? 1 : -1) * std::numeric_limits<double>::epsilon();
      const auto relaxed = relax(body, material(name, young, 0.499), x);
      const auto& [summary, distance] = relaxed;
      CAPTURE(relaxed.summary.full_report());
      CHECK(summary.converged());
      CHECK(summary.iterations <= 3);
      CHECK(distance <= 1e-12);
    }
}

TEST_CASE("every projection bends a bar to the same minimum, and descends all the way") {
  for (const char* name : {"stable_neo_hookean", "arap", "symmetric_dirichlet"}) {
    CAPTURE(name);
    double best = std::numeric_limits<double>::quiet_NaN();
    for (const auto& projection : newton::projection_names()) {
      CAPTURE(projection);
      Bent bent;
      const auto energy = energies::make_energy(name);
      auto objective = bent.objective(energy);
      // Where the energy has a barrier the ends come back part of the way: the start must not be inverted.
      if (energy.has_barrier())
        for (int v = 0; v < bent.body.mesh.vertices.rows(); ++v)
          for (int c = 0; c < 3; ++c)
            bent.x[3 * v + c] = bent.body.mesh.vertices(v, c) * (c == 0 ? 1.1 : 1.0) +
                                (c == 1 ? 0.05 * bent.body.mesh.vertices(v, 0) : 0.0);
      newton::Options options = tight();
      options.projection = newton::projection_from_name(projection);
      options.max_iterations = 300;
      const auto summary = newton::minimize(objective, bent.x, options);
      CAPTURE(summary.full_report());
      CHECK(summary.converged());
      if (std::isnan(best)) best = summary.energy;
      CHECK(summary.energy == doctest::Approx(best).epsilon(1e-8));
      for (std::size_t i = 1; i < summary.trace.size(); ++i)
        CHECK(summary.trace[i].energy <= summary.trace[i - 1].energy + 1e-13 * std::abs(best));
    }
  }
}

TEST_CASE("progressive projection filters a part of what clamping filters") {
  const auto filtered = [](Projection projection) {
    Bent bent;
    auto objective = bent.objective(energies::make_energy("stable_neo_hookean", {{"lambda", 100.0}}));
    newton::Options options = tight();
    options.projection = projection;
    const auto summary = newton::minimize(objective, bent.x, options);
    CHECK(summary.converged());
    std::size_t sum = 0;
    for (const auto& row : summary.trace) sum += row.points_filtered;
    return sum;
  };
  CHECK(filtered(Projection::progressive) < filtered(Projection::clamp));
}

TEST_CASE("inexact solves end at the same minimum with any preconditioner") {
  Bent reference;
  const auto energy = energies::make_energy("stable_neo_hookean", {{"lambda", 20.0}});
  auto direct = reference.objective(energy);
  const double expected = newton::minimize(direct, reference.x, tight()).energy;
  for (const auto preconditioner : {sparse::Preconditioner::jacobi, sparse::Preconditioner::block_jacobi,
                                    sparse::Preconditioner::incomplete_cholesky,
                                    sparse::Preconditioner::stale_cholesky, sparse::Preconditioner::amg})
    for (const double forcing : {0.0, 0.1, 0.5}) {
      CAPTURE(sparse::preconditioner_name(preconditioner));
      CAPTURE(forcing);
      Bent bent;
      auto objective = bent.objective(energy);
      newton::Options options = tight();
      options.solver.backend = sparse::Backend::pcg;
      options.solver.pcg_preconditioner = preconditioner;
      options.largest_forcing = forcing;
      const auto summary = newton::minimize(objective, bent.x, options);
      CAPTURE(summary.full_report());
      CHECK(summary.converged());
      CHECK(summary.energy == doctest::Approx(expected).epsilon(1e-8));
      CHECK(summary.solver == "pcg " + std::string(sparse::preconditioner_name(preconditioner)));
    }
}

TEST_CASE("a scaled term counts that many times, one of scale 0 not at all, domain included") {
  const Body body = bar();
  newton::Objective objective(3, body.elements.node_count);
  auto& first = objective.add<newton::EnergyTerm>(body.elements, energies::make_energy("symmetric_arap"));
  auto& second = objective.add<newton::EnergyTerm>(body.elements, energies::make_energy("arap"));
  const Vector x = 1.1 * body.rest(), mirrored = -body.rest();
  const double both = objective.value(x).value;
  second.set_scale(0);
  const double one = objective.value(x).value;
  first.set_scale(3);
  CHECK(objective.value(x).value == doctest::Approx(3 * one).epsilon(1e-15));
  first.set_scale(0);
  second.set_scale(1);
  CHECK(objective.value(x).value == doctest::Approx(both - one).epsilon(1e-12));
  CHECK(std::isfinite(objective.value(mirrored).value));
  CHECK_FALSE(objective.has_barrier());
  Vector gradient;
  second.set_scale(0.5);
  const double h = 1e-6;
  objective.differentiate(x, {}, gradient, false);
  Vector plus = x, minus = x;
  plus[5] += h;
  minus[5] -= h;
  CHECK(
      gradient[5] ==
      doctest::Approx((objective.value(plus).value - objective.value(minus).value) / (2 * h)).epsilon(1e-6));
  CHECK_THROWS_WITH_AS(first.set_scale(-1), doctest::Contains("-1"), Error);
  CHECK_THROWS_AS(first.set_scale(std::nan("")), Error);
}

TEST_CASE("the near-incompressible scenarios: iterations of the published filters and of the default" *
          outside_data({"meshes/tets/bob.mesh"}) * slow_under_sanitizers()) {
  mesh::TetMesh bob = mesh::read_tets(outside_path("meshes/tets/bob.mesh"));
  bob.vertices.rowwise() -= bob.vertices.colwise().mean().eval();
  bob.vertices /= bob.vertices.rowwise().norm().maxCoeff();
  const Body body(bob);
  const double mu = 3.3344e7, lambda = 100 * mu;
  const auto iterations = [&](Projection projection, double expansion) {
    newton::Objective objective(3, body.elements.node_count);
    auto& term = objective.add<newton::EnergyTerm>(
        body.elements, energies::make_energy("stable_neo_hookean", {{"mu", mu}, {"lambda", lambda}}));
    term.set_scale(3);
    Vector x = body.rest();
    const double low = bob.vertices.col(0).minCoeff(), high = bob.vertices.col(0).maxCoeff();
    double y = 0, z = 0, count = 0;
    for (int v = 0; v < bob.vertices.rows(); ++v)
      if (bob.vertices(v, 0) > high - 0.1) y += bob.vertices(v, 1), z += bob.vertices(v, 2), ++count;
    for (int v = 0; v < bob.vertices.rows(); ++v) {
      const bool moved = bob.vertices(v, 0) > high - 0.1;
      if (moved || bob.vertices(v, 0) < low + 0.1) objective.pin(v);
      if (!moved) continue;
      x[3 * v] += 1.2 * (high - low);
      x[3 * v + 1] = y / count - (bob.vertices(v, 2) - z / count);
      x[3 * v + 2] = z / count + (bob.vertices(v, 1) - y / count);
    }
    newton::Options options;
    options.projection = projection;
    options.decrement_tolerance = 1e-5 * lambda;
    options.scaled_gradient_tolerance = 0;
    options.armijo = 1e-8;
    options.backtracking_factor = 0.8;
    options.max_expansion = expansion;
    const auto summary = newton::minimize(objective, x, options);
    CHECK(summary.converged());
    return summary.iterations;
  };
  CHECK(iterations(Projection::abs, 1) <= 29);
  CHECK(iterations(Projection::clamp, 1) <= 51);
  CHECK(iterations(Projection::adaptive, 64) <= 29);
}

TEST_CASE("a linear solve that was cut short proves no convergence") {
  const auto excess = [](int limit) {
    Bent bent;
    auto objective = bent.objective(material("stable_neo_hookean", 1, 0.4999));
    newton::Options options;
    options.scaled_gradient_tolerance = 0;
    options.decrement_tolerance = 1e-9;
    options.max_iterations = 300;
    options.solver.backend = sparse::Backend::pcg;
    options.solver.pcg_preconditioner = sparse::Preconditioner::incomplete_cholesky;
    options.solver.pcg_max_iterations = limit;
    const auto summary = newton::minimize(objective, bent.x, options);
    CAPTURE(summary.full_report());
    if (summary.status == newton::Status::converged_decrement)
      CHECK(summary.energy - newton::minimize(objective, bent.x, tight()).energy <= 1e-8);
  };
  excess(10);
  excess(0);
}
