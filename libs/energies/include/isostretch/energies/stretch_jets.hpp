#pragma once

// Everything else from psi(sigma) alone, by second-order jets over the stretches: for energies that are no
// function of the invariants anybody would write down (Hencky, Ogden and other sums over stretches). Kernel
// templates.
//
// Twists are (psi_j + psi_k) / (sigma_j + sigma_k). Flips, (psi_j - psi_k) / (sigma_j - sigma_k), cancel
// where two stretches are nearly equal; psi being symmetric, they are there the mean of psi_jj - 2 psi_jk +
// psi_kk over 2 on the way from equal stretches to the ones at hand, for which two Gauss points suffice
// (error below rounding at a gap of near_share). That evaluates psi twice more a pair, for packs in which
// some lane is near.

#include <isostretch/energies/forms.hpp>

namespace isostretch::energies {
inline namespace ISOSTRETCH_ISA {

namespace detail {

template <int Dim, class T, class Energy>
ISOSTRETCH_INLINE invariants::Jet2<T> jet_of_psi(const Energy& energy, const PrincipalStretches<Dim, T>& s) {
  PrincipalStretches<Dim, invariants::Jet2<T>> jets;
  for (int i = 0; i < Dim; ++i) jets.sigma[i] = invariants::Jet2<T>(s[i], i + 1);
  return energy.psi(jets);
}

template <class T>
ISOSTRETCH_INLINE T first_derivative(const invariants::Jet2<T>& jet, int i) {
  return i == 0 ? jet.d1 : i == 1 ? jet.d2 : jet.d3;
}
template <class T>
ISOSTRETCH_INLINE T second_derivative(const invariants::Jet2<T>& jet, int i) {
  return i == 0 ? jet.d11 : i == 1 ? jet.d22 : jet.d33;
}
template <class T>
ISOSTRETCH_INLINE T mixed_derivative(const invariants::Jet2<T>& jet, int j, int k) {
  const int sum = j + k;
  return sum == 1 ? jet.d12 : sum == 3 ? jet.d23 : jet.d13;
}

/// Returns the flip of a pair whose stretches are near each other.
template <int Dim, class T, class Energy>
ISOSTRETCH_INLINE T flip_nearby(const Energy& energy, const PrincipalStretches<Dim, T>& s, int j, int k) {
  constexpr double gauss[] = {0.21132486540518711775, 0.78867513459481288225};  // on [0, 1]
  const T middle = T(0.5) * (s[j] + s[k]), half = T(0.5) * (s[j] - s[k]);
  T mean(0.0);
  for (const double u : gauss) {
    PrincipalStretches<Dim, T> at = s;
    at.sigma[j] = fma(half, T(u), middle);
    at.sigma[k] = fma(-half, T(u), middle);
    const auto jet = jet_of_psi(energy, at);
    mean =
        mean + T(0.5) * (second_derivative(jet, j) + second_derivative(jet, k)) - mixed_derivative(jet, j, k);
  }
  return T(0.5) * mean;
}

}  // namespace detail

/// Computes psi and its derivatives from psi(sigma) alone, by second-order jets over the stretches.
template <int Dim, class T, class Energy>
ISOSTRETCH_INLINE void derivatives_by_stretch_jets(const Energy& energy, const PrincipalStretches<Dim, T>& s,
                                                   StretchDerivatives<Dim, T>& d) {
  constexpr double near_share = 1e-3;
  const auto jet = detail::jet_of_psi(energy, s);
  d.psi = jet.v;
  for (int i = 0; i < Dim; ++i) {
    d.gradient[i] = detail::first_derivative(jet, i);
    d.diagonal[i] = detail::second_derivative(jet, i);
  }
  for (int i = 0; i < d.pairs; ++i) {
    const int j = first<Dim>(i), k = second<Dim>(i);
    const T gap = s[j] - s[k];
    const auto near = abs(gap) < T(near_share) * (abs(s[j]) + abs(s[k]));
    d.twist[i] = (d.gradient[j] + d.gradient[k]) / s.safe_sum(i);
    d.coupling[i] = detail::mixed_derivative(jet, j, k);
    d.flip[i] = (d.gradient[j] - d.gradient[k]) / select(near, T(1.0), gap);
    if (any(near)) d.flip[i] = select(near, detail::flip_nearby(energy, s, j, k), d.flip[i]);
  }
}

}  // namespace ISOSTRETCH_ISA
}  // namespace isostretch::energies
