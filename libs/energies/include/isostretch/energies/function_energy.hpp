#pragma once

// An energy may also be a plain function of numbers, as it stands on paper:
//
//   struct Mine {
//     static constexpr const char* name = "mine";
//     template <class T> T operator()(T I1, T I2, T I3) const { return I2 - 2.0 * I1 + 2.0 * I3; }
//   };
//
// or, said to be of_stretches, of two or three of these:
//
//   struct Ogden {
//     static constexpr const char* name = "ogden";
//     static constexpr bool of_stretches = true;
//     template <class... T> auto operator()(T... sigma) const { return (isostretch::pow(sigma, 1.5) + ...); }
//   };
//
// All else that a struct may give (evaluate.hpp) stays as it is.

#include <isostretch/invariants/partials.hpp>
#include <isostretch/invariants/stretch.hpp>

#include <type_traits>
#include <utility>

namespace isostretch::energies {

template <class Energy>
concept FunctionEnergy = !requires {
  Energy::has_psi;
}
&&(
    requires(const Energy& energy, double x) { energy(x, x, x); } ||
    requires(const Energy& energy, double x) { energy(x, x); });

inline namespace ISOSTRETCH_ISA {

// The struct with a psi that calls it.
template <FunctionEnergy Energy>
struct FunctionAsPsi : Energy {
  static constexpr bool has_psi = true;
  static constexpr bool takes_stretches = requires { requires Energy::of_stretches; };

  template <int Dim, class T>
  requires(!takes_stretches) ISOSTRETCH_INLINE T psi(const invariants::Invariants<Dim, T>& I)
  const { return (*this)(I.I1, I.I2, I.I3); }
  template <int Dim, class T>
  requires takes_stretches ISOSTRETCH_INLINE T psi(const invariants::Stretch<Dim, T>& s)
  const {
    if constexpr (Dim == 2)
      return (*this)(s[0], s[1]);
    else
      return (*this)(s[0], s[1], s[2]);
  }
};

// What has a psi already is itself.
template <class Energy>
auto with_psi(Energy energy) {
  if constexpr (FunctionEnergy<Energy>) {
    static_assert(!std::is_final_v<Energy>, "an energy with operator() must not be final");
    return FunctionAsPsi<Energy>{std::move(energy)};
  } else {
    return energy;
  }
}

}  // namespace ISOSTRETCH_ISA
}  // namespace isostretch::energies
