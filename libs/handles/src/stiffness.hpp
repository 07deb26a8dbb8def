#pragma once

#include <isostretch/assembly/elements.hpp>

#include <vector>

namespace isostretch::handles {

struct Entry {
  int column = 0;
  double value = 0;
};

// A symmetric matrix by its whole rows, columns ascending.
using Rows = std::vector<std::vector<Entry>>;

// The Laplacian K, without what is but rounding.
Rows stiffness_rows(const assembly::Elements& elements);

// K M^-1 K. Where the mass is zero, at nodes of no element, K is zero too.
Rows squared(const Rows& K, const std::vector<double>& mass);

}  // namespace isostretch::handles
