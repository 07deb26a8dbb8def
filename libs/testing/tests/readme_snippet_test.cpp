// The snippets of README.md, compiled; and proof that check_energy notices what is wrong.
#include <isostretch/testing/check_energy.hpp>

#include <doctest/doctest.h>

#include <string>

namespace {

// snippet: my energy
struct MyEnergy {
  static constexpr const char* name = "my_energy";
  static constexpr double minimum_determinant = 0.0;

  template <int Dim, class T>
  T psi(const isostretch::energies::Invariants<Dim, T>& I) const {
    using isostretch::log;
    return I.I2 - 2.0 * I.I1 + 0.1 * log(I.I3) * log(I.I3);
  }
};

TEST_CASE("my energy keeps its promises") {
  const auto report = isostretch::testing::check_energy(MyEnergy{});
  CHECK_MESSAGE(report.ok(), report.text());
}
// end of snippet

using isostretch::energies::Invariants;
using isostretch::energies::PrincipalStretches;
using isostretch::energies::StretchDerivatives;

// ARAP with one number wrong in the closed form, chosen by the test.
struct Broken {
  static constexpr const char* name = "broken";
  double gradient = 0, twist = 0, flip = 0, coupling = 0;

  template <int Dim, class T>
  T psi(const Invariants<Dim, T>& I) const {
    return I.I2 - 2.0 * I.I1;
  }

  template <int Dim, class T>
  void derivatives(const PrincipalStretches<Dim, T>& s, StretchDerivatives<Dim, T>& d) const {
    d.psi = psi(s.invariants());
    for (int i = 0; i < Dim; ++i) d.gradient[i] = 2.0 * s[i] - 2.0 + gradient, d.diagonal[i] = T(2.0);
    for (int i = 0; i < s.pairs; ++i) {
      d.twist[i] = 2.0 - 4.0 / s.safe_sum(i) + twist;
      d.flip[i] = T(2.0 + flip);
      d.coupling[i] = T(coupling);
    }
  }
};

bool fails(const Broken& energy, const std::string& what) {
  const auto report = isostretch::testing::check_energy(energy);
  for (const auto& check : report.checks)
    if (check.what == what) return !check.ok();
  return false;
}

// Claims a barrier it does not have.
struct NoBarrier : Broken {
  static constexpr double minimum_determinant = 0.0;
};

}  // namespace

namespace {

struct FunctionEnergy {
  static constexpr const char* name = "function_energy";
  static constexpr double minimum_determinant = 0.0;
  template <class T>
  T operator()(T I1, T I2, T I3) const {
    using isostretch::log;
    return I2 - 2.0 * I1 + 0.1 * log(I3) * log(I3);
  }
};

// Roots of negative numbers: no energy under inversion, and no barrier said.
struct Ogden {
  static constexpr const char* name = "ogden";
  static constexpr bool of_stretches = true;
  template <class... T>
  auto operator()(T... sigma) const {
    using isostretch::pow;
    return (pow(sigma, 1.5) + ...);
  }
};

}  // namespace

TEST_CASE("an energy may be a function of numbers") {
  const auto report = isostretch::testing::check_energy(FunctionEnergy{});
  CHECK_MESSAGE(report.ok(), report.text());
  CHECK(report.name == "function_energy");
  CHECK_FALSE(isostretch::testing::check_energy(Ogden{}).ok());
}

TEST_CASE("check_energy notices a single wrong entry") {
  const auto sound = isostretch::testing::check_energy(Broken{});
  CHECK_MESSAGE(sound.ok(), sound.text());
  CHECK(fails({.gradient = 1e-6}, "gradient = automatic"));
  CHECK(fails({.twist = 1e-6}, "assembled Hessian = automatic"));
  CHECK(fails({.flip = -1e-6}, "eigenpairs: H v = lambda v"));
  CHECK(fails({.coupling = 1e-3}, "Hessian = differences"));
}

TEST_CASE("check_energy notices a barrier that is none") {
  const auto report = isostretch::testing::check_energy(NoBarrier{});
  CHECK_FALSE(report.ok());
  CHECK(report.text().find("grows without bound") != std::string::npos);
}
