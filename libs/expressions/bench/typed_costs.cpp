// What a typed energy costs a quadrature point beside the hand-written one, and what a struct with psi alone
// (derivatives by jets) costs: stress and projected Hessian from F, in one run, one thread.
//
//   isostretch_typed_costs
#include "../tests/typed_builtins.hpp"

#include <isostretch/energies/builtin/arruda_boyce.hpp>
#include <isostretch/energies/builtin/exponential_amips.hpp>
#include <isostretch/energies/builtin/fixed_corotational.hpp>
#include <isostretch/energies/builtin/fung.hpp>
#include <isostretch/energies/builtin/hencky.hpp>
#include <isostretch/energies/builtin/mips_2d.hpp>
#include <isostretch/energies/builtin/mips_3d.hpp>
#include <isostretch/energies/builtin/mooney_rivlin_3d.hpp>
#include <isostretch/energies/builtin/neo_hookean_log.hpp>
#include <isostretch/energies/builtin/st_venant_kirchhoff.hpp>
#include <isostretch/energies/builtin/stable_neo_hookean.hpp>
#include <isostretch/energies/builtin/stable_neo_hookean_log.hpp>
#include <isostretch/energies/builtin/symmetric_arap.hpp>
#include <isostretch/energies/builtin/symmetric_dirichlet.hpp>
#include <isostretch/energies/builtin/symmetric_gradient.hpp>
#include <isostretch/energies/builtin/volume_symmetric.hpp>
#include <isostretch/energies/registry.hpp>
#include <isostretch/expressions/expression.hpp>
#include <isostretch/projection/projection.hpp>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <exception>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace isostretch;

// psi of an energy of the library by its invariants or its stretches, and nothing else of it.
template <class Energy>
struct Alone {
  static constexpr const char* name = "psi_alone";
  static constexpr double minimum_determinant = 0;
  static constexpr bool supports(int dim) { return energies::supports<Energy>(dim); }
  Energy energy;
};
template <class Energy>
struct OfInvariants : Alone<Energy> {
  template <int Dim, class T>
  T psi(const energies::Invariants<Dim, T>& I) const {
    return this->energy.psi(I);
  }
};
template <class Energy>
struct OfStretches : Alone<Energy> {
  template <int Dim, class T>
  T psi(const invariants::PrincipalStretches<Dim, T>& s) const {
    return this->energy.psi(s);
  }
};

// Deformation gradients near the identity, in blocks as projection::evaluate takes them.
struct Points {
  static constexpr std::size_t block = 64, count = 64 * 256;

  explicit Points(int dim) : entries(static_cast<std::size_t>(dim * dim)), F(entries * count) {
    std::mt19937 generator(1);
    std::normal_distribution<double> noise(0, 0.15);
    for (std::size_t i = 0; i < count; ++i)
      for (std::size_t e = 0; e < entries; ++e)
        F[i / block * block * entries + e * block + i % block] =
            (e % static_cast<std::size_t>(dim + 1) == 0 ? 1.0 : 0.0) + noise(generator);
  }
  std::size_t entries;
  std::vector<double> F;
};

double sink = 0;

// Nanoseconds a point of one pass over all.
double pass(const energies::AnyEnergy& energy, int dim, const Points& points) {
  constexpr std::size_t step = 4 * Points::block;
  std::vector<double> psi(step), P(points.entries * step),
      H(points.entries * (points.entries + 1) / 2 * step);
  const auto begin = std::chrono::steady_clock::now();
  for (std::size_t at = 0; at < Points::count; at += step) {
    projection::HessianBatch batch{points.F.data() + points.entries * at, psi.data(), P.data(), H.data()};
    batch.count = step;
    batch.block = Points::block;
    projection::evaluate(energy, dim, {}, batch);
    sink += H[0];
  }
  const std::chrono::duration<double, std::nano> spent = std::chrono::steady_clock::now() - begin;
  return spent.count() / Points::count;
}

// Medians of passes that take turns.
std::pair<double, double> compare(const energies::AnyEnergy& one, const energies::AnyEnergy& other, int dim) {
  const Points points(dim);
  std::vector<double> first, second;
  for (int i = 0; i < 41; ++i) {
    first.push_back(pass(one, dim, points));
    second.push_back(pass(other, dim, points));
  }
  const auto median = [](std::vector<double>& values) {
    std::nth_element(values.begin(), values.begin() + 20, values.end());
    return values[20];
  };
  return {median(first), median(second)};
}

void report(const char* name, const energies::AnyEnergy& one, const energies::AnyEnergy& other) {
  std::printf("| %s |", name);
  for (const int dim : {2, 3}) {
    if (!one.supports(dim) || !other.supports(dim)) {
      std::printf(" | | |");
      continue;
    }
    const auto [mine, theirs] = compare(one, other, dim);
    std::printf(" %.1f ns | %.1f ns | %.2f |", theirs, mine, mine / theirs);
  }
  std::printf("\n");
}

template <class Energy>
void report_jets() {
  constexpr int dim = energies::supports<Energy>(3) ? 3 : 2;
  const energies::AnyEnergy by_hand = energies::make_energy(Energy::name);
  if constexpr (requires(Energy e, energies::Invariants<dim, double> I) { e.psi(I); })
    report((std::string(Energy::name) + ", of invariants").c_str(), OfInvariants<Energy>{}, by_hand);
  if constexpr (requires(Energy e, invariants::PrincipalStretches<dim, double> s) { e.psi(s); })
    report((std::string(Energy::name) + ", of stretches").c_str(), OfStretches<Energy>{}, by_hand);
}
template <class... Energies>
void jets() {
  (report_jets<Energies>(), ...);
}

int run() {
  std::printf("| typed | 2D by hand | typed | ratio | 3D by hand | typed | ratio |\n");
  for (const auto& typed : tests::typed_builtins())
    report(typed.name.c_str(), expressions::parse_energy(typed.text, typed.parameters),
           energies::make_energy(typed.name, typed.parameters));
  std::printf("| psi alone | 2D by hand | jets | ratio | 3D by hand | jets | ratio |\n");
  using namespace energies;
  jets<ArrudaBoyce, ExponentialAmips, FixedCorotational, Fung, Hencky, Mips2d, Mips3d, MooneyRivlin3d,
       NeoHookeanLog, StVenantKirchhoff, StableNeoHookean, StableNeoHookeanLog, SymmetricArap,
       SymmetricDirichlet, SymmetricGradient, VolumeSymmetric>();
  return sink == sink ? 0 : 1;
}

}  // namespace

int main() {
  try {
    return run();
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
