// Every golden record, at every instruction-set level, for the scalar formulas and the chunk kernels.
#include "builtins.hpp"

#include <isostretch/energies/registry.hpp>
#include <isostretch/testing/eigensystem_checks.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#include "golden.hpp"

using namespace isostretch;
using namespace isostretch::energies;
using namespace isostretch::energies::tests;

namespace {

// Worst C so far of one level.
struct Worst {
  double psi = 0, grad = 0, H = 0, HP = 0;
};

// The struct called `name` with these parameters, evaluated as it stands: no guard outside the domain.
template <int Dim>
Derivatives<Dim> scalar_derivatives(const golden::Record& record, const PrincipalStretches<Dim, double>& s) {
  Derivatives<Dim> d{};
  for_each_builtin([&](auto energy) {
    using Energy = decltype(energy);
    if (record.energy != Energy::name) return;
    energy.parameters([&](const char* name, double& value, const char*) {
      const auto given = record.parameters.find(name);
      if (given != record.parameters.end()) value = given->second;
    });
    if constexpr (supports<Energy>(Dim)) {
      evaluate_derivatives(energy, s, d);
      CHECK(evaluate_psi(energy, s) == doctest::Approx(d.psi).epsilon(1e-13));
    }
  });
  return d;
}

void accept(double constant, double& worst, const std::string& what) {
  CAPTURE(std::string(what));
  CHECK(constant <= golden::acceptance);
  worst = std::max(worst, constant);
}

template <int Dim>
void check_derivatives(const golden::Record& record, const invariants::Modes<Dim>& modes,
                       const Derivatives<Dim>& d, Worst& worst) {
  const double H_scale = record.H.value.reshaped().stableNorm();
  const auto pairs = testing::analytic_eigenpairs<Dim>(modes, d);
  const Eigen::MatrixXd grad = testing::assemble_gradient<Dim>(modes, d);
  const Eigen::MatrixXd H = testing::assemble<Dim>(pairs, testing::KeepEigenvalue{});
  const Eigen::MatrixXd HP = testing::assemble<Dim>(pairs, testing::ClampEigenvalue{});
  accept(golden::needed_constant(grad, record.grad, record.grad.value.stableNorm()), worst.grad, "grad");
  accept(golden::needed_constant(H, record.H, H_scale), worst.H, "H");
  accept(golden::needed_constant(HP, record.HP, H_scale), worst.HP, "HP");
}

void check_psi(const golden::Record& record, double psi, Worst& worst) {
  const double reference = record.psi.value(0, 0);
  if (!record.smooth) CHECK(psi == doctest::Approx(reference).epsilon(1e-13));
  if (!record.comparable) return;
  const Eigen::MatrixXd value = Eigen::MatrixXd::Constant(1, 1, psi);
  accept(golden::needed_constant(value, record.psi, std::abs(reference)), worst.psi, "psi");
}

template <int Dim>
void check_finite(const Derivatives<Dim>& d) {
  for_each_entry<Dim>(d, d, [](const char* what, double value, double) {
    CAPTURE(std::string(what));
    CHECK(std::isfinite(value));
  });
}

template <int Dim>
void check_record(const golden::Record& record, const invariants::Modes<Dim>& modes, Worst& worst) {
  CAPTURE(record.energy);
  const auto s = modes.stretch();
  const AnyEnergy energy = make_energy(record.energy, record.parameters);
  const Derivatives<Dim> scalar = scalar_derivatives<Dim>(record, s);
  const Derivatives<Dim> chunk = PointChunk<Dim>(s).derivatives(energy);
  check_psi(record, scalar.psi, worst);
  if (s.J() > energy.determinant_bound()) {
    check_psi(record, chunk.psi, worst);
    CHECK(PointChunk<Dim>(s).psi(energy) == doctest::Approx(chunk.psi).epsilon(1e-13));
  } else {
    CHECK(std::isinf(chunk.psi));
  }
  for (const auto& d : {scalar, chunk}) {
    check_finite<Dim>(d);
    if (record.comparable) check_derivatives<Dim>(record, modes, d, worst);
  }
}

template <int Dim>
void check_all() {
  const auto cases = golden::read(Dim);
  at_every_level([&](Isa isa) {
    CAPTURE(isa_name(isa));
    Worst worst;
    int count = 0;
    for (const auto& c : cases) {
      CAPTURE(c.id);
      CAPTURE(c.category);
      const invariants::Modes<Dim> modes{Eigen::Matrix<double, Dim, Dim>(c.F)};
      for (const auto& record : c.records) check_record<Dim>(record, modes, worst), ++count;
    }
    CHECK(count > 1000);
    MESSAGE(Dim, "D at ", isa_name(isa), ": ", count, " records, worst C: psi ", worst.psi, ", grad ",
            worst.grad, ", H ", worst.H, ", HP ", worst.HP);
  });
}

}  // namespace

TEST_CASE("golden data in 2D") {
  check_all<2>();
}

TEST_CASE("golden data in 3D") {
  check_all<3>();
}

TEST_CASE("there are golden data of every built-in energy, in each of its dimensions") {
  for (const int dim : {2, 3}) {
    std::map<std::string, int> records;
    for (const auto& c : golden::read(dim))
      for (const auto& record : c.records) records[record.energy] += record.comparable;
    for_each_builtin([&](auto energy) {
      if (!supports<decltype(energy)>(dim)) return;
      CAPTURE(dim);
      CAPTURE(std::string(energy.name));
      CHECK(records[energy.name] >= 20);
    });
  }
}
