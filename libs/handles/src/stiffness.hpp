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

// K_ab = sum of w g_a . g_b.
Rows stiffness_rows(const assembly::Elements& elements);

// Of every node; the integral of its shape function would be negative at the corners of quadratic tets.
std::vector<double> lumped_mass(const assembly::Elements& elements);

// K M^-1 K. Where the mass is zero, at nodes of no element, K is zero too.
Rows squared(const Rows& K, const std::vector<double>& mass);

}  // namespace isostretch::handles
