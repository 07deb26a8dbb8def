#pragma once

#include <isostretch/energies/any_energy.hpp>

#include <array>
#include <string>
#include <vector>

namespace isostretch::app::inspect {

// Principal stretches; in the plane the third is not used.
using Stretches = std::array<double, 3>;

// What is below this share of the largest eigenvalue may be rounding.
inline constexpr double rounding = 1e-10;

enum class Mode { twist, flip, scaling };
inline constexpr std::array<Mode, 3> all_modes{Mode::twist, Mode::flip, Mode::scaling};
std::string mode_name(Mode mode);

// What the Hessian of an energy is made of at one stretch: eigenvalues of its twists and flips (in space
// that of pair i at i; in the plane there is one) and of its scaling block, ascending.
struct Spectrum {
  int dim = 3;
  Stretches at{1, 1, 1};
  double psi = 0;  // +infinity outside of the domain, where all else is meaningless
  std::array<double, 3> stress{};
  std::array<double, 3> eigenvalues[3]{};  // by mode
  double diagonal = 0, coupling = 0;       // A_11 and A_12

  bool in_domain() const;
  int count(Mode mode) const { return mode == Mode::scaling || dim == 3 ? dim : 1; }
  const std::array<double, 3>& of(Mode mode) const { return eigenvalues[static_cast<std::size_t>(mode)]; }
  double least(Mode mode) const;
  double least() const;
  // The largest magnitude of an eigenvalue: what rounding is measured against.
  double size() const;
  // Beyond rounding.
  bool is_negative(Mode mode) const;
  bool is_positive(Mode mode) const;
};

std::vector<Spectrum> spectra(const energies::AnyEnergy& energy, int dim, const std::vector<Stretches>& at);
Spectrum spectrum(const energies::AnyEnergy& energy, int dim, const Stretches& at);

}  // namespace isostretch::app::inspect
