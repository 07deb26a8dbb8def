#pragma once

#include <isostretch/energies/any_energy.hpp>

#include <array>
#include <string>
#include <vector>

namespace isostretch::inspection {

/// Principal stretches; in the plane the third is not used.
using Stretches = std::array<double, 3>;

/// Share of the largest eigenvalue below which a value may be rounding.
inline constexpr double rounding = 1e-10;

/// The kinds of eigenvectors of the Hessian of an isotropic energy.
enum class Mode {
  twist,   ///< Skew-symmetric changes in a plane of two principal axes.
  flip,    ///< Symmetric changes in such a plane.
  scaling  ///< Changes of the stretches.
};
/// All modes, in their order.
inline constexpr std::array<Mode, 3> all_modes{Mode::twist, Mode::flip, Mode::scaling};
/// Returns the name of the enumerator, such as "twist".
std::string mode_name(Mode mode);

/// The parts of the Hessian of an energy at one stretch.
struct Spectrum {
  int dim = 3;            ///< Dimension, 2 or 3.
  Stretches at{1, 1, 1};  ///< Principal stretches.
  double psi = 0;         ///< Energy; +infinity outside of the domain, where all else is meaningless.
  std::array<double, 3> stress{};  ///< Derivatives of psi by the stretches.
  /// Eigenvalues by mode: of twists and flips that of pair i at i, of which there is one in the plane; of the
  /// scaling block in ascending order.
  std::array<double, 3> eigenvalues[3]{};
  double diagonal = 0;  ///< Entry A_11 of the scaling block.
  double coupling = 0;  ///< Entry A_12 of the scaling block.

  /// Returns whether the stretch is in the domain of the energy.
  bool in_domain() const;
  /// Returns the number of eigenvalues of a mode.
  int count(Mode mode) const { return mode == Mode::scaling || dim == 3 ? dim : 1; }
  /// Returns the eigenvalues of a mode, count() of them.
  const std::array<double, 3>& of(Mode mode) const { return eigenvalues[static_cast<std::size_t>(mode)]; }
  /// Returns the least eigenvalue of a mode.
  double least(Mode mode) const;
  /// Returns the least eigenvalue of all.
  double least() const;
  /// Returns the largest magnitude of an eigenvalue: what rounding is measured against.
  double size() const;
  /// Returns whether an eigenvalue of the mode is negative beyond rounding.
  bool is_negative(Mode mode) const;
  /// Returns whether all eigenvalues of the mode are positive beyond rounding.
  bool is_positive(Mode mode) const;
};

/// Returns the spectra at many stretches, evaluated in chunks. The energy must exist in that dimension.
std::vector<Spectrum> spectra(const energies::AnyEnergy& energy, int dim, const std::vector<Stretches>& at);
/// Returns the spectrum at one stretch.
Spectrum spectrum(const energies::AnyEnergy& energy, int dim, const Stretches& at);

}  // namespace isostretch::inspection
