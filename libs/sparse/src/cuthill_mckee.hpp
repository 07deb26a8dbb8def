#pragma once

#include <vector>

namespace isostretch::sparse {

// Reverse Cuthill-McKee ordering (Cuthill & McKee 1969; George 1971) of a symmetric graph by compressed rows:
// position -> node. Neighbours come close to each other.
std::vector<int> reverse_cuthill_mckee(const std::vector<int>& start, const std::vector<int>& neighbour);

}  // namespace isostretch::sparse
