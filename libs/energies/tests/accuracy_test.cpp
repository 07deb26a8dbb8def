// Digits of the forms in sigma: every entry of every energy against psi(sigma) differentiated automatically
// in quadruple precision, over stretches from 1e-6 to 1e6 in all combinations. Component by component: norms
// would not see a twist of 1 beside a scaling eigenvalue of 1e24, but its sign is what a projection acts on.
#include "builtins.hpp"

#include <isostretch/testing/automatic_scalar.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#if defined(ISOSTRETCH_HAVE_QUADMATH)
#include <quadmath.h>

using namespace isostretch;
using namespace isostretch::energies;
using namespace isostretch::energies::tests;

__extension__ using Quad = __float128;

template <>
struct isostretch::testing::RealFunctions<Quad> {
  static Quad log(Quad x) { return logq(x); }
  static Quad log1p(Quad x) { return log1pq(x); }
  static Quad exp(Quad x) { return expq(x); }
  static Quad expm1(Quad x) { return expm1q(x); }
  static Quad sqrt(Quad x) { return sqrtq(x); }
  static Quad cbrt(Quad x) { return cbrtq(x); }
  static Quad pow(Quad x, Quad p) { return powq(x, p); }
};

namespace {

// Twist and flip from their definitions: sums and difference quotients of the principal stresses. Differences
// of stretches as close as 1e-9 leave 16 digits of the 34.
template <int Dim, class Energy>
StretchDerivatives<Dim, Quad> reference(const Energy& energy, const std::array<Quad, Dim>& sigma) {
  using Scalar = testing::AutomaticScalar<Quad, Dim>;
  PrincipalStretches<Dim, Scalar> s;
  for (int i = 0; i < Dim; ++i) s.sigma[i] = Scalar::variable(sigma[static_cast<std::size_t>(i)], i);
  const Scalar psi = energy.psi(s);
  StretchDerivatives<Dim, Quad> d;
  d.psi = psi.value;
  for (int i = 0; i < Dim; ++i) {
    d.gradient[i] = psi.gradient[i];
    d.diagonal[i] = psi.hessian[i * Dim + i];
  }
  for (int i = 0; i < d.pairs; ++i) {
    const int j = first<Dim>(i), k = second<Dim>(i);
    const Quad a = s[j].value, b = s[k].value;
    d.coupling[i] = psi.hessian[j * Dim + k];
    d.twist[i] = (d.gradient[j] + d.gradient[k]) / (a + b);
    d.flip[i] = a == b ? d.diagonal[j] - d.coupling[i] : (d.gradient[j] - d.gradient[k]) / (a - b);
  }
  return d;
}

template <int Dim>
std::array<Quad, Dim> widened(const PrincipalStretches<Dim, double>& s) {
  std::array<Quad, Dim> sigma;
  for (int i = 0; i < Dim; ++i) sigma[static_cast<std::size_t>(i)] = s[i];
  return sigma;
}

// What the reference itself loses where parts of psi that are large cancel in its derivatives.
template <int Dim>
StretchDerivatives<Dim, Quad> quadruple_rounding(const PrincipalStretches<Dim, double>& s, Quad psi) {
  const Quad rounding = psi * 0x1p-108;
  StretchDerivatives<Dim, Quad> d{};
  for (int i = 0; i < Dim; ++i) {
    const Quad size = fabsq(s[i]);
    d.gradient[i] = rounding / size;
    d.diagonal[i] = rounding / (size * size);
  }
  for (int i = 0; i < d.pairs; ++i) d.twist[i] = d.flip[i] = d.coupling[i] = rounding / fabsq(s.product(i));
  return d;
}

// What the entries of `exact` change by when sigma_i changes by half a unit in its last place, summed over i:
// the error no form can be blamed for, and all there is at a true change of sign.
template <int Dim, class Energy>
StretchDerivatives<Dim, Quad> sensitivity(const Energy& energy, const PrincipalStretches<Dim, double>& s,
                                          const StretchDerivatives<Dim, Quad>& exact) {
  auto sum = quadruple_rounding<Dim>(s, fabsq(exact.psi));
  for (int i = 0; i < Dim; ++i) {
    auto moved = widened(s);
    moved[static_cast<std::size_t>(i)] += fabsq(moved[static_cast<std::size_t>(i)]) * 0x1p-53;
    const auto other = reference<Dim>(energy, moved);
    for (int e = 0; e < Dim; ++e) {
      sum.gradient[e] += fabsq(other.gradient[e] - exact.gradient[e]);
      sum.diagonal[e] += fabsq(other.diagonal[e] - exact.diagonal[e]);
    }
    for (int e = 0; e < sum.pairs; ++e) {
      sum.twist[e] += fabsq(other.twist[e] - exact.twist[e]);
      sum.flip[e] += fabsq(other.flip[e] - exact.flip[e]);
      sum.coupling[e] += fabsq(other.coupling[e] - exact.coupling[e]);
    }
  }
  return sum;
}

// Descending combinations of a few magnitudes; the last one also negative if asked for.
template <int Dim>
std::vector<PrincipalStretches<Dim, double>> graded_stretches(bool inverted) {
  const std::vector<double> magnitudes = {1e6, 37.0, 1.25, 1.0, 0.9, 3e-3, 1e-6};
  std::vector<PrincipalStretches<Dim, double>> all;
  const auto add = [&](double a, double b, double c) {
    PrincipalStretches<Dim, double> s;
    s.sigma[0] = a;
    s.sigma[1] = b;
    s.sigma[Dim - 1] = c;
    all.push_back(s);
    s.sigma[Dim - 1] = -c;
    // Opposite stretches are not smooth; the sums are bounded from below there.
    if (inverted && s[Dim - 2] + s[Dim - 1] > 0) all.push_back(s);
  };
  for (std::size_t i = 0; i < magnitudes.size(); ++i)
    for (std::size_t j = i; j < magnitudes.size(); ++j) {
      if constexpr (Dim == 2) {
        add(magnitudes[i], magnitudes[i], magnitudes[j]);
      } else {
        for (std::size_t k = j; k < magnitudes.size(); ++k) add(magnitudes[i], magnitudes[j], magnitudes[k]);
      }
    }
  return all;
}

double ratio(Quad error, Quad allowed) {
  if (error == 0) return 0;
  return static_cast<double>(error / allowed);
}

// The largest |value - exact| / (eps |exact| + sensitivity).
template <int Dim>
double needed_constant(const Derivatives<Dim>& value, const StretchDerivatives<Dim, Quad>& exact,
                       const StretchDerivatives<Dim, Quad>& sens, std::string& worst_entry) {
  double worst = 0;
  std::vector<Quad> allowed;
  for_each_entry<Dim>(
      exact, sens, [&](const char*, Quad x, Quad change) { allowed.push_back(fabsq(x) * 0x1p-52 + change); });
  std::size_t next = 0;
  for_each_entry<Dim>(value, exact, [&](const char* what, double x, Quad y) {
    const double constant = ratio(fabsq(x - y), allowed[next++]);
    if (constant > worst) worst_entry = what;
    worst = std::max(worst, constant);
  });
  return worst;
}

// Exponentials overflow; what is left is compared as long as it is a number.
template <int Dim>
bool in_range(const StretchDerivatives<Dim, Quad>& d) {
  bool ok = fabsq(d.psi) < Quad(1e250);
  for_each_entry<Dim>(d, d, [&](const char*, Quad x, Quad) { ok = ok && fabsq(x) < Quad(1e250); });
  return ok;
}

// Roundings allowed in one entry; the worst seen is 31, in mooney_rivlin_3d.
constexpr double allowed_constant = 64;

template <int Dim, class Energy>
void check_graded(const Energy& energy) {
  const AnyEnergy any = energy;
  double worst = 0;
  int count = 0;
  for (const auto& s : graded_stretches<Dim>(!any.has_barrier())) {
    if (any.has_barrier() && !(s.J() > any.determinant_bound())) continue;
    const auto exact = reference<Dim>(energy, widened(s));
    if (!in_range<Dim>(exact)) continue;
    const auto sens = sensitivity<Dim>(energy, s, exact);
    ++count;
    at_every_level([&](Isa isa) {
      std::string entry;
      const double constant = needed_constant<Dim>(PointChunk<Dim>(s).derivatives(any), exact, sens, entry);
      CAPTURE(isa_name(isa));
      CAPTURE(entry);
      CAPTURE(s[0]);
      CAPTURE(s[1]);
      CAPTURE(s[Dim - 1]);
      CHECK(constant <= allowed_constant);
      worst = std::max(worst, constant);
    });
  }
  CHECK(count >= 9);  // exponentials overflow on most
  MESSAGE(std::string(Energy::name), " ", Dim, "D: ", count, " stretches, worst C ", worst);
}

// Near rest the twist vanishes with the strain. Relative to itself, without allowing for a change of sigma.
template <int Dim, class Energy>
void check_twist_near_rest(const Energy& energy) {
  // Its psi has a rounded constant, which moves the rest state of the reference by a rounding.
  const double offset = std::string_view(Energy::name) == "stable_neo_hookean_log" ? 4e-16 : 0.0;
  for (const double e : {1e-3, 1e-6, 1e-9}) {
    PrincipalStretches<Dim, double> s;
    for (int i = 0; i < Dim; ++i) s.sigma[i] = 1.0 + e * (1.7 - 0.6 * i);
    const auto exact = reference<Dim>(energy, widened(s));
    at_every_level([&](Isa isa) {
      const auto d = PointChunk<Dim>(s).derivatives(energy);
      CAPTURE(isa_name(isa));
      CAPTURE(e);
      for (int i = 0; i < d.pairs; ++i) {
        const Quad error = fabsq(d.twist[i] - exact.twist[i]);
        CHECK(error <= 2e-13 * fabsq(exact.twist[i]) + offset);
      }
    });
  }
}

// psi by the invariants, where the energy knows it, in quadruple precision: other formulas than the forms in
// sigma.
template <int Dim, class Energy>
Quad reference_psi(const Energy& energy, const std::array<Quad, Dim>& sigma) {
  using Scalar = testing::AutomaticScalar<Quad, Dim>;
  PrincipalStretches<Dim, Scalar> s;
  for (int i = 0; i < Dim; ++i) s.sigma[i] = Scalar(sigma[static_cast<std::size_t>(i)]);
  if constexpr (requires { energy.psi(s.invariants()); }) {
    return energy.psi(s.invariants()).value;
  } else {
    return energy.psi(s).value;
  }
}

// Rotations and similarities but for a strain of e: there the terms of isochoric energies cancel.
template <int Dim>
std::vector<PrincipalStretches<Dim, double>> nearly_similar_stretches() {
  std::vector<PrincipalStretches<Dim, double>> all;
  for (const double scale : {1.0, 0.25, 3.0})
    for (const double e : {1e-1, 1e-2, 1e-4, 1e-6, 1e-7}) {
      PrincipalStretches<Dim, double> s;
      for (int i = 0; i < Dim; ++i) s.sigma[i] = scale * (1.0 + e * (1.3 - 0.9 * i));
      all.push_back(s);
    }
  return all;
}

template <int Dim, class Energy>
void check_psi_near_similarities(const Energy& energy) {
  const AnyEnergy any = energy;
  double worst = 0;
  for (const auto& s : nearly_similar_stretches<Dim>()) {
    const Quad exact = reference_psi<Dim>(energy, widened(s));
    Quad allowed = fabsq(exact) * 0x1p-52;
    for (int i = 0; i < Dim; ++i) {
      auto moved = widened(s);
      moved[static_cast<std::size_t>(i)] *= 1 + Quad(0x1p-53);
      allowed += fabsq(reference_psi<Dim>(energy, moved) - exact);
    }
    const auto check = [&](double psi) {
      const double constant = ratio(fabsq(psi - exact), allowed);
      CAPTURE(s[0]);
      CAPTURE(s[Dim - 1]);
      CHECK(constant <= 30);
      worst = std::max(worst, constant);
    };
    check(evaluate_psi(energy, s));
    at_every_level([&](Isa) {
      check(PointChunk<Dim>(s).psi(any));
      PointChunk<Dim> chunk(s);
      check(chunk.derivatives(any).psi);
    });
  }
  MESSAGE(std::string(Energy::name), " ", Dim, "D: worst C of psi ", worst);
}

template <class Energy, class Check>
void in_each_dimension(const Energy&, Check check) {
  if constexpr (supports<Energy>(2)) check(std::integral_constant<int, 2>());
  if constexpr (supports<Energy>(3)) check(std::integral_constant<int, 3>());
}

}  // namespace

TEST_CASE("forms in sigma keep their digits from 1e-6 to 1e6") {
  for_each_varied_builtin([](auto energy) {
    const std::string name = energy.name;
    CAPTURE(name);
    in_each_dimension(energy, [&](auto dim) { check_graded<dim>(energy); });
  });
}

TEST_CASE("twists keep their digits near rest") {
  for_each_varied_builtin([](auto energy) {
    const std::string name = energy.name;
    CAPTURE(name);
    in_each_dimension(energy, [&](auto dim) { check_twist_near_rest<dim>(energy); });
  });
}

TEST_CASE("psi keeps its digits near rotations and similarities") {
  for_each_varied_builtin([](auto energy) {
    const std::string name = energy.name;
    CAPTURE(name);
    in_each_dimension(energy, [&](auto dim) { check_psi_near_similarities<dim>(energy); });
  });
}

#endif
