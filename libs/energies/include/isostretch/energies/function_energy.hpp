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
//     template <class... T> auto operator()(T... sigma) const {
//       using isostretch::pow;
//       return (pow(sigma, 1.5) + ...);
//     }
//   };
//
// All else that a struct may give (evaluate.hpp) stays as it is.

#include <isostretch/energies/evaluate.hpp>

#include <type_traits>
#include <utility>

namespace isostretch::energies {

/// An energy that has a psi of the invariants or of the stretches in dimension Dim.
template <class Energy, int Dim>
concept HasPsi = requires(const Energy& energy, invariants::Invariants<Dim, double> I) {
  energy.psi(I);
}
|| requires(const Energy& energy, invariants::PrincipalStretches<Dim, double> s) {
  energy.psi(s);
};
/// An energy that is callable with two numbers.
template <class Energy>
concept OfTwoNumbers = requires(const Energy& energy, double x) {
  energy(x, x);
};
/// An energy that is callable with three numbers.
template <class Energy>
concept OfThreeNumbers = requires(const Energy& energy, double x) {
  energy(x, x, x);
};

/// An energy that is a plain function of two or three numbers, the invariants or the stretches, and has no
/// psi.
template <class Energy>
concept FunctionEnergy =
    !HasPsi<Energy, 2> && !HasPsi<Energy, 3> && (OfTwoNumbers<Energy> || OfThreeNumbers<Energy>);

inline namespace ISOSTRETCH_ISA {

/// A function energy as a struct whose psi calls it.
template <FunctionEnergy Energy>
struct FunctionAsPsi : Energy {
  /// Whether the function is one of stretches, not of invariants.
  static constexpr bool takes_stretches = requires { requires Energy::of_stretches; };
  /// Returns whether the function takes as many numbers as dimension `dim` has invariants or stretches.
  static constexpr bool supports(int dim) {
    const bool is_called = takes_stretches && dim == 2 ? OfTwoNumbers<Energy> : OfThreeNumbers<Energy>;
    return is_called && energies::supports<Energy>(dim);
  }

  /// Returns the value of the function at the invariants.
  template <int Dim, class T>
  requires(!takes_stretches) ISOSTRETCH_INLINE T psi(const invariants::Invariants<Dim, T>& I)
  const { return (*this)(I.I1, I.I2, I.I3); }
  /// Returns the value of the function at the principal stretches.
  template <int Dim, class T>
  requires takes_stretches ISOSTRETCH_INLINE T psi(const invariants::PrincipalStretches<Dim, T>& s)
  const {
    if constexpr (Dim == 2)
      return (*this)(s[0], s[1]);
    else
      return (*this)(s[0], s[1], s[2]);
  }
};

/// Returns the energy with a psi: itself if it has one, else a FunctionAsPsi of it.
template <class Energy>
auto with_psi(Energy energy) {
  if constexpr (FunctionEnergy<Energy>) {
    using WithPsi = FunctionAsPsi<Energy>;
    static_assert(!std::is_final_v<Energy>, "an energy with operator() must not be final");
    static_assert(WithPsi::supports(2) || WithPsi::supports(3),
                  "operator() takes I1, I2, I3 or, said to be of_stretches, two or three stretches");
    return WithPsi{std::move(energy)};
  } else {
    return energy;
  }
}

}  // namespace ISOSTRETCH_ISA
}  // namespace isostretch::energies
