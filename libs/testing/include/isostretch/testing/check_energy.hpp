#pragma once

// Everything an energy promises, checked in one call:
//
//   struct Mine {
//     static constexpr const char* name = "mine";
//     template <int Dim, class T> T psi(const isostretch::energies::Invariants<Dim, T>& I) const {
//       return I.I2 - 2.0 * I.I1;
//     }
//   };
//   const auto report = isostretch::testing::check_energy(Mine{});
//   CHECK_MESSAGE(report.ok(), report.text());
//
// In each dimension that the energy supports, over the samples of deformation_samples.hpp that lie in its
// domain: psi does not change under rotations, psi(sigma) does not depend on the order of sigma and equals
// psi(I1, I2, I3); gradient and Hessian agree with automatic differentiation in the entries of F and with
// finite differences; the analytic eigenpairs and projections agree with numerical ones; a barrier is
// infinite outside its domain; everything is finite at degenerate stretch.

#include <isostretch/energies/evaluate.hpp>
#include <isostretch/energies/function_energy.hpp>
#include <isostretch/testing/automatic_derivatives.hpp>
#include <isostretch/testing/difference_derivatives.hpp>
#include <isostretch/testing/energy_report.hpp>

#include <array>
#include <cstddef>
#include <optional>

namespace isostretch::testing {

/// The choices of check_energy().
struct EnergyCheckOptions {
  int random_samples = 8;       ///< Random deformation gradients besides the degenerate ones.
  unsigned seed = 1;            ///< Seed of the random samples.
  double psi_tolerance = 1e-9;  ///< Tolerance of psi, relative to |psi| + |gradient| |F| + |A| |F|^2.
  /// Tolerance of the closed form against automatic differentiation, relative to the norm.
  double derivative_tolerance = 1e-9;
  double difference_tolerance = 1e-6;  ///< Tolerance against finite differences in double.
};

namespace detail {

/// The derivatives of an energy along the stretch, as invariants::StretchDerivatives has them, of arrays
/// alone: the library is compiled once, and energies with the flags of whoever checks them.
struct PlainDerivatives {
  double psi = 0;
  double gradient[3]{}, diagonal[3]{}, twist[3]{}, flip[3]{}, coupling[3]{};
};

/// The functions of an energy in one dimension that the checks call. `sigma` are the principal stretches, F
/// is column by column.
class CheckedEnergy {
 public:
  virtual ~CheckedEnergy() = default;
  virtual double psi(const double* sigma) const = 0;
  virtual PlainDerivatives derivatives(const double* sigma) const = 0;
  /// Returns psi(I1, I2, I3) of an energy that has both forms, none otherwise.
  virtual std::optional<double> psi_of_invariants(const double* sigma) const = 0;
  /// Gives psi, gradient and Hessian over the entries of F by another way: automatic differentiation of an
  /// energy in invariants, differences of one in sigma.
  virtual void witness(const double* F, double& psi, double* gradient, double* hessian) const = 0;
  /// Returns psi through the chunk kernel, which is where the barrier is built in.
  virtual double guarded_psi(const double* sigma) const = 0;
  virtual double determinant_bound() const = 0;
  virtual bool from_invariants() const = 0;
  /// Returns whether the energy says of itself that its scaling modes do not couple.
  virtual bool decoupled() const = 0;
};

template <int Dim, class Energy>
class CheckedEnergyOf final : public CheckedEnergy {
 public:
  explicit CheckedEnergyOf(const Energy& energy) : energy_(energy) {}

  double psi(const double* sigma) const override { return energies::evaluate_psi(energy_, stretches(sigma)); }

  PlainDerivatives derivatives(const double* sigma) const override {
    invariants::StretchDerivatives<Dim, double> d;
    energies::evaluate_derivatives(energy_, stretches(sigma), d);
    PlainDerivatives result{.psi = d.psi};
    for (int i = 0; i < Dim; ++i) {
      result.gradient[i] = d.gradient[i];
      result.diagonal[i] = d.diagonal[i];
    }
    for (int i = 0; i < d.pairs; ++i) {
      result.twist[i] = d.twist[i];
      result.flip[i] = d.flip[i];
      result.coupling[i] = d.coupling[i];
    }
    return result;
  }

  std::optional<double> psi_of_invariants([[maybe_unused]] const double* sigma) const override {
    if constexpr (has_invariants && has_stretch) return energy_.psi(stretches(sigma).invariants());
    return std::nullopt;
  }

  void witness(const double* F, double& psi, double* gradient, double* hessian) const override {
    const EntryDerivatives<Dim> d = witness_of(Eigen::Map<const Eigen::Matrix<double, Dim, Dim>>(F));
    psi = d.psi;
    for (int i = 0; i < Dim * Dim; ++i) gradient[i] = d.gradient[i];
    for (int i = 0; i < Dim * Dim * Dim * Dim; ++i) hessian[i] = d.hessian.data()[i];
  }

  double guarded_psi(const double* sigma) const override {
    constexpr int count = 8;
    std::array<double, Dim * count> in{};
    std::array<double, count> out{};
    for (int e = 0; e < Dim; ++e)
      for (int i = 0; i < count; ++i) in[static_cast<std::size_t>(e * count + i)] = sigma[e];
    energies::StretchChunk chunk;
    chunk.count = count;
    chunk.stride = count;
    chunk.sigma = in.data();
    chunk.psi = out.data();
    energies::detail::functions_of<Energy>().psi[Dim - 2](&energy_, chunk);
    return out[0];
  }

  double determinant_bound() const override { return energies::determinant_bound(energy_); }
  bool from_invariants() const override { return has_invariants; }

  bool decoupled() const override {
    if constexpr (requires { Energy::decoupled; }) return Energy::decoupled;
    return false;
  }

 private:
  using PrincipalStretches = invariants::PrincipalStretches<Dim, double>;

  static constexpr bool has_invariants = requires(const Energy& e, invariants::Invariants<Dim, double> I) {
    e.psi(I);
  };
  static constexpr bool has_stretch = requires(const Energy& e, PrincipalStretches s) { e.psi(s); };

  static PrincipalStretches stretches(const double* sigma) {
    PrincipalStretches s;
    for (int i = 0; i < Dim; ++i) s.sigma[i] = sigma[i];
    return s;
  }

  EntryDerivatives<Dim> witness_of(const Eigen::Matrix<double, Dim, Dim>& F) const {
    if constexpr (has_invariants)
      return automatic_derivatives<Dim>(energy_, F);
    else
      return difference_derivatives<Dim>(energy_, F);
  }

  const Energy& energy_;
};

/// Adds the checks of an energy in 2 or 3 dimensions to the report.
void run_checks(int dim, const CheckedEnergy& energy, const EnergyCheckOptions& options,
                EnergyReport& report);

}  // namespace detail

/// Checks everything that an energy promises, in each dimension that it supports, over the samples of
/// deformation_samples() that lie in its domain: psi does not change under rotations, psi(sigma) does not
/// depend on the order of sigma and equals psi(I1, I2, I3); gradient and Hessian agree with automatic
/// differentiation in the entries of F and with finite differences; the analytic eigenpairs and projections
/// agree with numerical ones; a barrier is infinite outside its domain; everything is finite at degenerate
/// stretch. Returns the checks with their worst cases.
template <class Energy>
EnergyReport check_energy(const Energy& energy, const EnergyCheckOptions& options = {}) {
  if constexpr (energies::FunctionEnergy<Energy>) {
    return check_energy(energies::with_psi(energy), options);
  } else {
    EnergyReport report;
    report.name = Energy::name;
    if constexpr (energies::supports<Energy>(2))
      detail::run_checks(2, detail::CheckedEnergyOf<2, Energy>(energy), options, report);
    if constexpr (energies::supports<Energy>(3))
      detail::run_checks(3, detail::CheckedEnergyOf<3, Energy>(energy), options, report);
    return report;
  }
}

}  // namespace isostretch::testing
