#pragma once

// What an energy may give and how the rest is derived from it. Kernel templates.
//
// An energy is a struct with a `name` and one of
//   template <int Dim, class T> T psi(const Invariants<Dim, T>& I) const;
//   template <int Dim, class T> T psi(const PrincipalStretches<Dim, T>& s) const;
// each of which is enough by itself, since jets derive the rest (and so is an operator(),
// function_energy.hpp). Instead of the jets it may give one of
//   template <int Dim, class T> Partials<T> partials(const Invariants<Dim, T>& I) const;
//   template <int Dim, class T> void derivatives(const PrincipalStretches<Dim, T>& s, StretchDerivatives<Dim,
//   T>&) const;
// Forms in sigma are fastest, and accurate at any stretch. Further members that it may have:
//   static constexpr double minimum_determinant;    // a barrier: psi = +infinity at det F <= this
//   double determinant_bound() const;               // the same where it depends on a parameter
//   static constexpr bool supports(int dim);        // both dimensions unless it says otherwise
//   static constexpr bool decoupled;                // A is diagonal: no eigen-solve
//   template <class V> void parameters(V&& visit);  // visit("name", member, "description") for each
//   template <class R> void require_parameters(R&& require) const;
//       // require("name", member > 0, "must be positive") for each rule; an AnyEnergy whose parameters
//       // break one is refused
//
// Inside psi, functions of T are isostretch::log, exp, sqrt, pow(x, double), cbrt, ...: `using
// isostretch::log;`.

#include <isostretch/energies/chunk.hpp>
#include <isostretch/energies/chunk_access.hpp>
#include <isostretch/energies/forms.hpp>
#include <isostretch/energies/stretch_jets.hpp>

namespace isostretch::energies {

/// Returns whether the energy exists in dimension `dim`: in 2 and 3 unless its own supports() says otherwise.
template <class Energy>
constexpr bool supports(int dim) {
  if constexpr (requires { Energy::supports(dim); }) {
    return Energy::supports(dim);
  } else {
    return dim == 2 || dim == 3;
  }
}

/// Returns the number that det F must stay above for the energy to be finite; -infinity for energies that are
/// finite everywhere.
template <class Energy>
double determinant_bound(const Energy& energy) {
  if constexpr (requires { energy.determinant_bound(); }) {
    return energy.determinant_bound();
  } else if constexpr (requires { Energy::minimum_determinant; }) {
    return Energy::minimum_determinant;
  } else {
    return -__builtin_inf();
  }
}

inline namespace ISOSTRETCH_ISA {

/// Returns psi at a stretch, from whichever form the energy gives.
template <int Dim, class T, class Energy>
ISOSTRETCH_INLINE T evaluate_psi(const Energy& energy, const PrincipalStretches<Dim, T>& s) {
  if constexpr (requires { energy.psi(s); }) {
    return energy.psi(s);
  } else {
    return energy.psi(s.invariants());
  }
}

/// Computes psi and its derivatives at a stretch: by the energy's own derivatives(), its partials(), or jets
/// over psi.
template <int Dim, class T, class Energy>
ISOSTRETCH_INLINE void evaluate_derivatives(const Energy& energy, const PrincipalStretches<Dim, T>& s,
                                            StretchDerivatives<Dim, T>& d) {
  if constexpr (requires { energy.derivatives(s, d); }) {
    energy.derivatives(s, d);
  } else if constexpr (requires { energy.partials(s.invariants()); }) {
    invariants::derivatives_from_partials(s, energy.partials(s.invariants()), d);
  } else if constexpr (requires { energy.psi(s.invariants()); }) {
    invariants::derivatives_from_partials(s, invariants::partials_by_jets(energy, s.invariants()), d);
  } else {
    derivatives_by_stretch_jets(energy, s, d);
  }
}

namespace detail {

template <class Energy>
inline constexpr bool has_barrier = requires(const Energy& e) {
  e.determinant_bound();
}
|| requires {
  Energy::minimum_determinant;
};

template <int Dim, class Energy>
ISOSTRETCH_INLINE Pack guarded(const Energy& energy, const PrincipalStretches<Dim, Pack>& s, Pack psi) {
  if constexpr (has_barrier<Energy>) {
    const Pack infinity(__builtin_inf());
    // Not (J > bound), so that NaN counts as outside; an overflow inside the domain is infinite as well.
    return select(s.J() > Pack(energies::determinant_bound(energy)), select(psi <= infinity, psi, infinity),
                  infinity);
  }
  return psi;
}

template <int Dim, class Energy>
ISOSTRETCH_FLATTEN void psi_of_chunk(const void* object, const StretchChunk& chunk) {
  const Energy energy = *static_cast<const Energy*>(object);
  for (int i = 0; i < chunk.count; i += lanes) {
    const auto s = load_stretch<Dim>(chunk, i);
    store(chunk.psi + i, guarded(energy, s, evaluate_psi(energy, s)));
  }
}

template <int Dim, class Energy>
ISOSTRETCH_FLATTEN void derivatives_of_chunk(const void* object, const StretchChunk& chunk) {
  const Energy energy = *static_cast<const Energy*>(object);
  for (int i = 0; i < chunk.count; i += lanes) {
    const auto s = load_stretch<Dim>(chunk, i);
    StretchDerivatives<Dim, Pack> d;
    evaluate_derivatives(energy, s, d);
    store(chunk.psi + i, guarded(energy, s, d.psi));
    store_derivatives(chunk, i, d);
  }
}

template <class Energy>
constexpr EnergyFunctions functions_of() {
  EnergyFunctions f{};
  if constexpr (supports<Energy>(2)) {
    f.psi[0] = psi_of_chunk<2, Energy>;
    f.derivatives[0] = derivatives_of_chunk<2, Energy>;
  }
  if constexpr (supports<Energy>(3)) {
    f.psi[1] = psi_of_chunk<3, Energy>;
    f.derivatives[1] = derivatives_of_chunk<3, Energy>;
  }
  return f;
}

}  // namespace detail
}  // namespace ISOSTRETCH_ISA
}  // namespace isostretch::energies
