#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace isostretch::projection {

/// The change made to the eigenvalues of the energy Hessian at a quadrature point.
enum class Filter {
  none,  ///< Keeps the exact, possibly indefinite Hessian.
  /// Takes max(lambda, threshold), which gives the nearest positive semi-definite matrix (Teran et al. 2005).
  clamp,
  abs,  ///< Takes max(|lambda|, threshold) (Chen et al. 2024).
  /// Takes weight |lambda| for negative lambda, but not beyond the largest magnitude among the eigenvalues
  /// of flips and scaling: the twists of energies with I1 tend to minus infinity where sigma_j + sigma_k
  /// vanishes, and their absolute values would make the body rigid there. Strength 0 is clamping.
  bounded_abs,
};

/// The filter of a Hessian and its parameters.
struct FilterOptions {
  Filter filter = Filter::clamp;  ///< The change made to each eigenvalue.
  /// The smallest eigenvalue after filtering, in the units of psi. Zero keeps semi-definite blocks as they
  /// are.
  double threshold = 0.0;
  /// The share of the change that is made: lambda + weight (filtered - lambda). 1 filters fully, 0 not at
  /// all; Filter::bounded_abs says what it makes of it.
  double weight = 1.0;
  /// A byte per node, or null; read by assembly alone. Where it is given, elements without a node whose byte
  /// is other than zero keep their exact Hessian.
  const unsigned char* nodes = nullptr;
};

/// Returns the name of the filter, such as "bounded_abs".
std::string_view filter_name(Filter filter) noexcept;
/// Returns the filter of this name. Throws Error, which names the filters that exist, if there is none.
Filter filter_from_name(std::string_view name);
/// Returns the names of all filters.
std::vector<std::string> filter_names();

}  // namespace isostretch::projection
