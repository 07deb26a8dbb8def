#pragma once

#include <isostretch/core/error.hpp>
#include <isostretch/core/isa.hpp>
#include <isostretch/energies/evaluate.hpp>
#include <isostretch/energies/function_energy.hpp>

#include <array>
#include <memory>
#include <string>
#include <typeinfo>
#include <utility>
#include <vector>

namespace isostretch::energies {

/// A named number of an energy, such as a shear modulus.
struct Parameter {
  std::string name;         ///< The name, as energies on the command line and in scenes spell it.
  double value;             ///< The present value.
  std::string description;  ///< A short description for users.
};

/// An energy that evaluates whole chunks by itself, instead of a struct for which templates are compiled: one
/// made of other energies, or at run time. psi() and derivatives() fill padding points too.
class ChunkEnergy {
 public:
  virtual ~ChunkEnergy() = default;
  /// Returns the name of the energy.
  virtual std::string name() const = 0;
  /// Returns whether the energy exists in dimension `dim`, 2 or 3.
  virtual bool supports(int dim) const = 0;
  /// Returns the number that det F must stay above: 0 for a barrier, -infinity for an energy that is finite
  /// under inversion.
  virtual double determinant_bound() const = 0;
  /// Returns whether A, the Hessian of psi over the stretches, has off-diagonal entries for some F.
  virtual bool coupled() const = 0;
  /// Returns the parameters with their present values; none unless overridden.
  virtual std::vector<Parameter> parameters() const { return {}; }

  /// Computes chunk.psi from chunk.sigma, +infinity outside the domain.
  virtual void psi(int dim, const StretchChunk& chunk) const = 0;
  /// Computes psi and all derivatives in the chunk from chunk.sigma.
  virtual void derivatives(int dim, const StretchChunk& chunk) const = 0;
};

/// Returns the kernels of a built-in energy, compiled for every instruction-set level, or null for any other
/// type, whatever its name: the kernels read the members of just that struct.
const std::array<EnergyFunctions, isa_count>* builtin_functions(const std::type_info& energy);

/// Any energy behind one type: cheap to copy, safe to share between threads, one indirect call per chunk.
///
/// Built-in energies run at the active instruction-set level. A user's own energy runs as it was compiled
/// where the AnyEnergy is made: give that source file -march=... for full speed.
class AnyEnergy {
 public:
  /// Makes an AnyEnergy of a struct as energies/evaluate.hpp describes it. Throws Error, naming the energy,
  /// if a parameter breaks a rule of require_parameters(), or if psi is NaN at an inverted stretch although
  /// no bound of the determinant is declared: the logarithm of a negative determinant would otherwise show
  /// only in the middle of a solve.
  template <class Energy>
  requires requires { Energy::name; }
  AnyEnergy(Energy energy);  // NOLINT: implicit on purpose, an energy is an AnyEnergy
  /// Makes an AnyEnergy of an energy that evaluates chunks by itself. Throws Error if psi is NaN at an
  /// inverted stretch although no bound of the determinant is declared.
  explicit AnyEnergy(std::shared_ptr<const ChunkEnergy> energy);

  /// Returns the name of the energy.
  const std::string& name() const noexcept { return name_; }
  /// Returns whether the energy exists in dimension `dim`, 2 or 3.
  bool supports(int dim) const noexcept { return functions_[0].psi[dim - 2] != nullptr; }
  /// Returns the number that det F must stay above: 0 for a barrier, -infinity for an energy that is finite
  /// under inversion.
  double determinant_bound() const noexcept { return determinant_bound_; }
  /// Returns whether the energy is infinite where det F is too small.
  bool has_barrier() const noexcept { return determinant_bound_ > -__builtin_inf(); }
  /// Returns whether A, the Hessian of psi over the stretches, has off-diagonal entries for some F.
  bool coupled() const noexcept { return coupled_; }
  /// Returns the parameters with their values.
  const std::vector<Parameter>& parameters() const noexcept { return parameters_; }

  /// Computes chunk.psi from chunk.sigma, +infinity outside the domain. The energy must support `dim`.
  void evaluate_psi(int dim, const StretchChunk& chunk) const { active().psi[dim - 2](object_.get(), chunk); }
  /// Computes psi and all derivatives in the chunk from chunk.sigma; derivatives outside the domain, where
  /// psi is infinite, are unspecified. The energy must support `dim`.
  void evaluate_derivatives(int dim, const StretchChunk& chunk) const {
    active().derivatives[dim - 2](object_.get(), chunk);
  }

 private:
  struct WithPsi {};
  template <class Energy>
  AnyEnergy(WithPsi, Energy energy);

  template <class Energy>
  void require_valid(const Energy& energy) const;
  /// Throws Error if psi is NaN at an inverted stretch that the energy does not declare to be outside its
  /// domain.
  void require_declared_domain() const;

  const EnergyFunctions& active() const { return functions_[static_cast<std::size_t>(active_isa())]; }

  std::shared_ptr<const void> object_;
  std::array<EnergyFunctions, isa_count> functions_;
  std::string name_;
  double determinant_bound_;
  bool coupled_;
  std::vector<Parameter> parameters_;
};

template <class Energy>
requires requires {
  Energy::name;
}
AnyEnergy::AnyEnergy(Energy energy) : AnyEnergy(WithPsi{}, with_psi(std::move(energy))) {}

template <class Energy>
AnyEnergy::AnyEnergy(WithPsi, Energy energy)
    : name_(Energy::name), determinant_bound_(energies::determinant_bound(energy)) {
  require_valid(energy);
  if (const auto* compiled = builtin_functions(typeid(Energy))) {
    functions_ = *compiled;
  } else {
    functions_.fill(detail::functions_of<Energy>());
  }
  if constexpr (requires { Energy::decoupled; }) {
    coupled_ = !Energy::decoupled;
  } else {
    coupled_ = true;
  }
  if constexpr (requires { energy.parameters([](const char*, double&, const char*) {}); }) {
    energy.parameters([this](const char* parameter, double& value, const char* description) {
      parameters_.push_back({parameter, value, description});
    });
  }
  object_ = std::make_shared<const Energy>(std::move(energy));
  require_declared_domain();
}

template <class Energy>
void AnyEnergy::require_valid(const Energy& energy) const {
  if constexpr (requires { energy.require_parameters([](const char*, bool, const char*) {}); }) {
    energy.require_parameters([this](const char* parameter, bool holds, const char* rule) {
      if (!holds) throw Error("energy '" + name_ + "': parameter '" + parameter + "' " + rule);
    });
  }
}

inline namespace ISOSTRETCH_ISA {

/// Returns psi and its derivatives at one stretch. Throws Error where the energy does not exist in this
/// dimension or is infinite.
template <int Dim>
StretchDerivatives<Dim, double> derivatives_at(const AnyEnergy& energy,
                                               const PrincipalStretches<Dim, double>& s) {
  if (!energy.supports(Dim))
    throw Error("energy '" + energy.name() + "' does not exist in " + std::to_string(Dim) + "D");
  constexpr int points = 8, pairs = invariants::pair_count<Dim>;  // the least that every kernel takes
  double sigma[Dim * points], psi[points], gradient[Dim * points], twist[pairs * points],
      flip[pairs * points], diagonal[Dim * points], coupling[pairs * points];
  for (int e = 0; e < Dim; ++e)
    for (int i = 0; i < points; ++i) sigma[e * points + i] = s.sigma[e];
  energy.evaluate_derivatives(Dim, {points, points, sigma, psi, gradient, twist, flip, diagonal, coupling});
  if (!(psi[0] < __builtin_inf()))
    throw Error("energy '" + energy.name() + "' is not finite at this stretch");
  StretchDerivatives<Dim, double> d;
  d.psi = psi[0];
  for (int e = 0; e < Dim; ++e) d.gradient[e] = gradient[e * points], d.diagonal[e] = diagonal[e * points];
  for (int e = 0; e < pairs; ++e) {
    d.twist[e] = twist[e * points];
    d.flip[e] = flip[e * points];
    d.coupling[e] = coupling[e * points];
  }
  return d;
}

}  // namespace ISOSTRETCH_ISA
}  // namespace isostretch::energies
