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
};

struct FilterOptions {
  Filter filter = Filter::clamp;
  // Smallest eigenvalue after filtering, in the units of psi. Zero keeps semi-definite blocks as they are.
  double threshold = 0.0;
  // How far an eigenvalue is moved: lambda + strength (filtered - lambda). 1 filters fully, 0 not at all.
  double strength = 1.0;
};

std::string_view filter_name(Filter filter) noexcept;
// Throws Error naming the filters there are.
Filter filter_from_name(std::string_view name);
std::vector<std::string> filter_names();

}  // namespace isostretch::projection
