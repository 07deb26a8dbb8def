#include "builtins.hpp"

#include <isostretch/core/error.hpp>
#include <isostretch/energies/registry.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

using namespace isostretch;
using namespace isostretch::energies;
using namespace isostretch::energies::tests;

namespace {

std::string message_of(const std::function<void()>& misuse) {
  try {
    misuse();
  } catch (const Error& error) {
    return error.what();
  }
  return "no error";
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

// psi alone, in one line: jets and the generic eigensystem do the rest.
struct UserEnergy {
  static constexpr const char* name = "user_energy";
  double weight = 1.0;

  template <class Visitor>
  void parameters(Visitor&& visit) {
    visit("weight", weight, "in front of everything");
  }

  template <int Dim, class T>
  T psi(const Invariants<Dim, T>& I) const {
    return weight * (I.I2 - 2.0 * I.I1 + double(Dim));
  }
};

struct UserEnergy2d {
  static constexpr const char* name = "user_energy_2d";
  static constexpr bool supports(int dim) { return dim == 2; }
  static constexpr double minimum_determinant = 0.0;

  template <int Dim, class T>
  T psi(const Invariants<Dim, T>& I) const {
    return I.I2 / I.I3;
  }
};

// psi of the stretches alone: no function of the invariants.
struct UserHencky {
  static constexpr const char* name = "user_hencky";
  static constexpr double minimum_determinant = 0.0;
  double mu = 1.0;

  template <class Visitor>
  void parameters(Visitor&& visit) {
    visit("mu", mu, "shear modulus");
  }

  template <int Dim, class T>
  T psi(const PrincipalStretches<Dim, T>& s) const {
    using isostretch::log;
    T squares(0.0), sum(0.0);
    for (int i = 0; i < Dim; ++i) {
      const T l = log(s[i]);
      squares = squares + l * l;
      sum = sum + l;
    }
    return mu * squares + 0.5 * (sum * sum);
  }
};

// As they stand on paper, of invariants and of stretches.
struct FunctionOfInvariants {
  static constexpr const char* name = "function_of_invariants";
  static constexpr double minimum_determinant = 0.0;
  double mu = 1.0, lambda = 1.0;

  template <class Visitor>
  void parameters(Visitor&& visit) {
    visit("mu", mu, "shear modulus");
    visit("lambda", lambda, "first Lame parameter");
  }

  template <class T>
  T operator()(T, T I2, T I3) const {
    using isostretch::log;
    return 0.5 * mu * I2 - mu * log(I3) + 0.5 * lambda * (log(I3) * log(I3));
  }
};

struct FunctionOfStretches {
  static constexpr const char* name = "function_of_stretches";
  static constexpr bool of_stretches = true;
  static constexpr double minimum_determinant = 0.0;

  template <class... T>
  auto operator()(T... sigma) const {
    using isostretch::log;
    using isostretch::square;
    return (square(log(sigma)) + ...) + 0.5 * square((log(sigma) + ...));
  }
};

// A psi, beside which an operator() may be anything; and a function of two stretches.
struct PsiAndMore : UserEnergy {
  static constexpr const char* name = "psi_and_more";
  double operator()(double a, double b, double c) const { return a + b + c; }
};

struct FunctionInThePlane {
  static constexpr const char* name = "function_in_the_plane";
  static constexpr bool of_stretches = true;
  template <class T>
  T operator()(T s1, T s2) const {
    return s1 * s1 + s2 * s2;
  }
};

const PrincipalStretches<3, double> stretched{{1.7, 1.1, 0.6}};

template <int Dim>
void check_same_derivatives(const AnyEnergy& one, const AnyEnergy& other,
                            const PrincipalStretches<Dim, double>& s) {
  const auto a = PointChunk<Dim>(s).derivatives(one), b = PointChunk<Dim>(s).derivatives(other);
  for_each_entry<Dim>(a, b, [](const char* entry, double x, double y) {
    CAPTURE(entry);
    CHECK(std::abs(x - y) <= 1e-13 * (1 + std::abs(y)));
  });
}

}  // namespace

TEST_CASE("names are sorted, unique, and those of the folder") {
  const auto names = energy_names();
  CHECK(std::is_sorted(names.begin(), names.end()));
  CHECK(std::adjacent_find(names.begin(), names.end()) == names.end());
  std::size_t count = 0;
  for_each_builtin([&](auto energy) {
    ++count;
    CHECK(std::find(names.begin(), names.end(), energy.name) != names.end());
  });
  CHECK(names.size() == count);
}

TEST_CASE("an unknown energy is refused with the list of those that exist") {
  const auto message = message_of([] { make_energy("symetric_dirichlet"); });
  CHECK(contains(message, "symetric_dirichlet"));
  for (const auto& name : energy_names()) CHECK(contains(message, name));
}

TEST_CASE("an unknown parameter is refused with the list of those that exist") {
  const auto message = message_of([] { make_energy("corotational", {{"lambda", 1.0}}); });
  CHECK(contains(message, "corotational"));
  CHECK(contains(message, "'lambda'"));
  CHECK(contains(message, "mu, kappa"));
  CHECK(contains(message_of([] { make_energy("arap", {{"mu", 1.0}}); }), "none"));
}

TEST_CASE("a parameter that is not a finite number is refused by name") {
  for (const double value :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()})
    CHECK(contains(message_of([&] { make_energy("hencky", {{"mu", value}}); }), "'mu'"));
}

TEST_CASE("parameters reach the kernels of every level and are reported back") {
  at_every_level([](Isa) {
    int checked = 0;
    for (const auto& name : energy_names()) {
      CAPTURE(name);
      const AnyEnergy before = make_energy(name);
      if (!before.supports(3)) continue;
      for (const auto& parameter : before.parameters()) {
        ++checked;
        CAPTURE(parameter.name);
        const AnyEnergy after = make_energy(name, {{parameter.name, 1.25 * parameter.value}});
        // The LIM barrier ends at det F = 1 + epsilon, hence a state below it.
        PointChunk<3> point(stretched), compressed(PrincipalStretches<3, double>{{1.1, 0.8, 0.6}});
        const bool differs =
            point.psi(before) != point.psi(after) || compressed.psi(before) != compressed.psi(after);
        CHECK(differs);
        const auto& given = after.parameters();
        CHECK(std::any_of(given.begin(), given.end(), [&](const Parameter& p) {
          return p.name == parameter.name && p.value == 1.25 * parameter.value && !p.description.empty();
        }));
      }
    }
    CHECK(checked > 20);
  });
}

TEST_CASE("what an AnyEnergy says about itself") {
  CHECK(make_energy("symmetric_dirichlet").has_barrier());
  CHECK(make_energy("symmetric_dirichlet").determinant_bound() == 0.0);
  CHECK(make_energy("lim_barrier", {{"epsilon", 0.25}}).determinant_bound() == 0.25);
  CHECK_FALSE(make_energy("arap").has_barrier());
  CHECK_FALSE(make_energy("arap").coupled());
  CHECK(make_energy("corotational").coupled());
  CHECK(make_energy("mips_2d").supports(2));
  CHECK_FALSE(make_energy("mips_2d").supports(3));
}

TEST_CASE("a user's psi runs through AnyEnergy at every level") {
  at_every_level([](Isa isa) {
    CAPTURE(isa_name(isa));
    const AnyEnergy user = UserEnergy{2.0};
    const AnyEnergy arap = make_energy("arap");
    CHECK(user.name() == "user_energy");
    CHECK(user.parameters().at(0).value == 2.0);
    const auto u = PointChunk<3>(stretched).derivatives(user), a = PointChunk<3>(stretched).derivatives(arap);
    CHECK(u.psi == doctest::Approx(2.0 * a.psi).epsilon(1e-13));
    for_each_entry<3>(
        u, a, [](const char*, double x, double y) { CHECK(x == doctest::Approx(2.0 * y).epsilon(1e-13)); });
  });
}

TEST_CASE("a user's barrier and dimension are respected") {
  const AnyEnergy energy = UserEnergy2d{};
  CHECK(energy.supports(2));
  CHECK_FALSE(energy.supports(3));
  CHECK(std::isinf(PointChunk<2>(PrincipalStretches<2, double>{{1.0, -0.5}}).psi(energy)));
  CHECK(PointChunk<2>(PrincipalStretches<2, double>{{2.0, 1.0}}).psi(energy) == doctest::Approx(2.5));
}

TEST_CASE("psi of the stretches alone is enough, also where stretches are equal or nearly") {
  at_every_level([](Isa isa) {
    CAPTURE(isa_name(isa));
    const AnyEnergy user = UserHencky{}, built = make_energy("hencky");
    for (const double gap : {0.3, 3e-3, 1.5e-3, 1e-4, 1e-7, 1e-12, 0.0}) {
      CAPTURE(gap);
      for (const PrincipalStretches<3, double>& s :
           {PrincipalStretches<3, double>{{1.2 + gap, 1.2, 0.7}},
            PrincipalStretches<3, double>{{1.4, 0.9 + gap, 0.9}},
            PrincipalStretches<3, double>{{1.1 + 2 * gap, 1.1 + gap, 1.1}}}) {
        const auto u = PointChunk<3>(s).derivatives(user), b = PointChunk<3>(s).derivatives(built);
        for_each_entry<3>(u, b, [](const char* entry, double x, double y) {
          CAPTURE(entry);
          CHECK(std::abs(x - y) <= 2e-12 * (1 + std::abs(y)));
        });
      }
    }
  });
}

TEST_CASE("an operator() of invariants or of stretches is enough") {
  at_every_level([](Isa isa) {
    CAPTURE(isa_name(isa));
    const AnyEnergy by_invariants = FunctionOfInvariants{2.0, 3.0}, by_stretches = FunctionOfStretches{};
    CHECK(by_invariants.name() == "function_of_invariants");
    CHECK(by_invariants.parameters().at(1).value == 3.0);
    CHECK(by_stretches.determinant_bound() == 0.0);
    const AnyEnergy neo_hookean = make_energy("neo_hookean_log", {{"mu", 2}, {"lambda", 3}});
    const PrincipalStretches<2, double> plane{{1.4, 0.8}};
    check_same_derivatives(by_invariants, neo_hookean, stretched);
    check_same_derivatives(by_invariants, neo_hookean, plane);
    check_same_derivatives(by_stretches, make_energy("hencky"), stretched);
    check_same_derivatives(by_stretches, make_energy("hencky"), plane);
  });
  CHECK(PointChunk<3>(stretched).psi(PsiAndMore{}) == PointChunk<3>(stretched).psi(UserEnergy{}));
  CHECK_FALSE(AnyEnergy(FunctionInThePlane{}).supports(3));
  CHECK(PointChunk<2>(PrincipalStretches<2, double>{{3.0, 2.0}}).psi(FunctionInThePlane{}) == 13.0);
  add_energy(entry_of<FunctionOfInvariants>());
  check_same_derivatives(make_energy("function_of_invariants", {{"mu", 5}}),
                         make_energy("neo_hookean_log", {{"mu", 5}}), stretched);
}

TEST_CASE("energies of a program's own are in the registry once it has added them") {
  CHECK(contains(message_of([] { make_energy("user_hencky"); }), "unknown energy"));
  add_energy(entry_of<UserHencky>());
  const auto names = energy_names();
  CHECK(std::is_sorted(names.begin(), names.end()));
  CHECK(std::find(names.begin(), names.end(), "user_hencky") != names.end());
  CHECK(PointChunk<3>(stretched).psi(make_energy("user_hencky", {{"mu", 3}})) ==
        doctest::Approx(PointChunk<3>(stretched).psi(make_energy("hencky", {{"mu", 3}}))).epsilon(1e-14));
  CHECK(contains(message_of([] {
                   make_energy("user_hencky", {{"nu", 3}});
                 }),
                 "no parameter 'nu'; it has mu"));
  CHECK(contains(message_of([] { add_energy(entry_of<UserHencky>()); }), "'user_hencky' already"));
}

namespace {

// A user's energy under the name of a built-in one, with members of another layout.
struct UsersNeoHookean {
  static constexpr const char* name = "neo_hookean_log";
  const char* label = "mine";
  double stiffness = 7.0;

  template <int Dim, class T>
  T psi(const Invariants<Dim, T>& I) const {
    return stiffness * I.I2;
  }
};

struct LogWithoutDomain {
  static constexpr const char* name = "log_without_domain";

  template <int Dim, class T>
  T psi(const Invariants<Dim, T>& I) const {
    using isostretch::log;
    return I.I2 - log(I.I3);
  }
};

struct RootWithoutDomain {
  static constexpr const char* name = "root_without_domain";

  template <int Dim, class T>
  T psi(const PrincipalStretches<Dim, T>& s) const {
    using isostretch::sqrt;
    return s.I2() + sqrt(s.J());
  }
};

struct InfiniteBelow {
  static constexpr const char* name = "infinite_below";

  template <int Dim, class T>
  T psi(const Invariants<Dim, T>& I) const {
    return I.I2 + select(I.I3 > 0.0, T(0.0), T(std::numeric_limits<double>::infinity()));
  }
};

}  // namespace

TEST_CASE("an energy with the name of a built-in one is evaluated as what it is") {
  PrincipalStretches<3, double> s;
  s.sigma[0] = 2, s.sigma[1] = 1.5, s.sigma[2] = 0.5;
  const AnyEnergy mine = UsersNeoHookean{};
  at_every_level([&](Isa) {
    CHECK(PointChunk<3>(s).psi(mine) == doctest::Approx(7.0 * s.I2()).epsilon(1e-15));
    CHECK(PointChunk<3>(s).derivatives(mine).gradient[0] == doctest::Approx(28.0).epsilon(1e-15));
  });
  CHECK(mine.parameters().empty());
  CHECK_FALSE(mine.has_barrier());
}

TEST_CASE("built-in energies are found by their type alone") {
  int count = 0;
  for_each_builtin([&](auto energy) {
    CHECK(builtin_functions(typeid(energy)) != nullptr);
    ++count;
  });
  CHECK(count > 20);
  CHECK(builtin_functions(typeid(UsersNeoHookean)) == nullptr);
  CHECK(builtin_functions(typeid(int)) == nullptr);
}

TEST_CASE("parameters that no material has are refused where the energy is made") {
  int refused = 0;
  for_each_builtin([&](auto energy) {
    using Energy = decltype(energy);
    std::vector<std::string> parameters;
    energy.parameters([&](const char* name, double&, const char*) { parameters.emplace_back(name); });
    for (const std::string& parameter : parameters) {
      CAPTURE(std::string(Energy::name));
      CAPTURE(parameter);
      const std::string message = message_of([&] { make_energy(Energy::name, {{parameter, -5.0}}); });
      // c01 alone may be anything that c10 makes up for.
      CHECK(contains(message, "energy '" + std::string(Energy::name) + "': parameter '" +
                                  (parameter == "c01" ? "c10" : parameter) + "'"));
      ++refused;
    }
  });
  CHECK(refused > 20);
  CHECK(make_energy("mooney_rivlin_3d", {{"c10", 1.0}, {"c01", -0.2}}).supports(3));
  CHECK(make_energy("neo_hookean_log", {{"mu", 1.0}, {"lambda", -0.5}}).supports(3));
}

TEST_CASE("an energy that is NaN where the determinant is negative must say so") {
  CHECK(contains(message_of([] { AnyEnergy{LogWithoutDomain{}}; }), "'log_without_domain'"));
  CHECK(contains(message_of([] { AnyEnergy{RootWithoutDomain{}}; }), "must declare minimum_determinant"));
  CHECK_FALSE(AnyEnergy(InfiniteBelow{}).has_barrier());
}
