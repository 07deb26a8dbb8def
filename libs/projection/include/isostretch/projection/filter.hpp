#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace isostretch::projection {

// What happens to eigenvalues of the energy Hessian at a quadrature point.
enum class Filter {
  none,   // nothing: the exact, possibly indefinite Hessian
  clamp,  // max(lambda, threshold): the nearest positive semi-definite matrix (Teran et al. 2005)
  abs,    // max(|lambda|, threshold) (Chen et al. 2024)
  // Negative lambda to strength |lambda|, but not beyond the largest magnitude among the eigenvalues of flips
  // and scaling: the twists of energies with I1 tend to minus infinity where sigma_j + sigma_k vanishes, and
  // taken by their absolute value would make the body rigid there. Strength 0 is clamping.
  bounded_abs,
};

struct FilterOptions {
  Filter filter = Filter::clamp;
  // Smallest eigenvalue after filtering, in the units of psi. Zero keeps semi-definite blocks as they are.
  double threshold = 0.0;
  // How far an eigenvalue is moved: lambda + strength (filtered - lambda). 1 filters fully, 0 not at all; but
  // see bounded_abs.
  double strength = 1.0;
  // Assembly only: when given, one byte a node, and the elements without a node that is marked by a byte
  // other than zero keep their exact Hessian.
  const unsigned char* nodes = nullptr;
};

std::string_view filter_name(Filter filter) noexcept;
// Throws Error naming the filters there are.
Filter filter_from_name(std::string_view name);
std::vector<std::string> filter_names();

}  // namespace isostretch::projection
