#pragma once

#include <isostretch/assembly/elements.hpp>

#include <vector>

namespace isostretch::handles {

// Component of every node, counted from 0 by smallest node; -1 for a node of no element. Elements that share
// a node belong together.
std::vector<int> component_of_nodes(const assembly::Elements& elements);

// Elements all of whose nodes are among the chosen ones, ascending.
std::vector<int> elements_within(const std::vector<int>& chosen, const assembly::Elements& elements);

// Those elements alone; nodes keep their numbers.
assembly::Elements restricted(const assembly::Elements& elements, const std::vector<int>& chosen);

}  // namespace isostretch::handles
