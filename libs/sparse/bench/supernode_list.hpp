#pragma once

#include <isostretch/sparse/matrix.hpp>
#include <isostretch/sparse/options.hpp>

#include <string>
#include <vector>

namespace isostretch::sparse::bench {

// The supernodes of a matrix in the order of elimination, one line of JSON each.
std::vector<std::string> supernode_list(const SymmetricMatrix& A, Ordering ordering);

}  // namespace isostretch::sparse::bench
