#pragma once

#include <isostretch/assembly/elements.hpp>
#include <isostretch/core/vector.hpp>
#include <isostretch/energies/any_energy.hpp>
#include <isostretch/newton/minimize.hpp>

#include <string>
#include <string_view>
#include <vector>

// What others do to minimise isotropic distortion energies, and ours, behind one call: on the same elements,
// energies, assembly, factorization, driver and line search, so that a comparison is one of methods.
namespace isostretch::baselines {

/// Minimise the sum over quadrature points of weight * psi(F), over the positions of all nodes but those
/// pinned.
struct DistortionProblem {
  /// The elements at rest.
  assembly::Elements elements;
  /// The energy that is minimised.
  energies::AnyEnergy energy;
  std::vector<int> pinned;  ///< nodes that stay where the start has them

  /// Throws Error naming the element or the pin at fault.
  void validate() const;
};

/// When a method stops.
struct MethodOptions {
  /// |gradient|_inf <= gradient_tolerance ends every method alike, in units of energy per length; with a
  /// total rest area of 1 published comparisons have 1e-4. 0: only where nothing improves any more.
  double gradient_tolerance = 1e-4;
  /// The largest number of iterations.
  int max_iterations = 1000;
  double time_limit = 0;  ///< seconds; 0: none

  /// Throws Error naming the first option that makes no sense.
  void validate() const;
};

/// The families of methods.
enum class Family {
  own,              ///< what isostretch offers
  newton,           ///< Hessians projected, or not, in other ways: equal steps in exact arithmetic, or nearly
  majorization,     ///< a positive definite matrix of another origin in every iteration
  constant_metric,  ///< one factorization for all iterations
};

/// Returns the enumerator's own name.
std::string_view family_name(Family family) noexcept;

/// A method that there is.
struct MethodInfo {
  std::string_view name;    ///< as on a command line
  std::string_view title;   ///< as in a table
  std::string_view source;  ///< paper
  /// The family of the method.
  Family family = Family::own;
};

/// Returns all that there are, ours first, in the order of a table.
std::vector<MethodInfo> methods();

/// Returns why a method is none for a problem (its dimension, energy or elements); empty where it is one.
/// Throws Error for an unknown name, listing those there are.
std::string why_not_applicable(std::string_view method, const DistortionProblem& problem);

/// Runs a method from x, which ends as the last positions of the trace (methods that are not monotone may
/// have seen better ones on the way). Throws Error for an unknown name, an invalid problem or options, and
/// where the method is not applicable; numerical outcomes are the Summary's status. The callback sees every
/// iterate; its time counts.
newton::Summary minimize(std::string_view method, const DistortionProblem& problem, Vector& x,
                         const MethodOptions& options = {}, const newton::IterationCallback& callback = {});

}  // namespace isostretch::baselines
