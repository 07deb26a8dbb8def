#pragma once

#include <isostretch/assembly/elements.hpp>

#include <vector>

namespace isostretch::handles {

using assembly::component_of_nodes;

/// Returns the elements all of whose nodes are among the chosen ones, ascending.
std::vector<int> elements_within(const std::vector<int>& chosen, const assembly::Elements& elements);

/// Returns the chosen elements alone; nodes keep their numbers.
assembly::Elements restricted(const assembly::Elements& elements, const std::vector<int>& chosen);

}  // namespace isostretch::handles
