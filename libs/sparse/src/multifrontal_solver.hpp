#pragma once

#include <isostretch/sparse/solver.hpp>

#include <memory>

namespace isostretch::sparse {

// Our own multifrontal Cholesky (library cholesky) behind the common interface.
std::unique_ptr<Solver> make_multifrontal_solver(const Options& options);

}  // namespace isostretch::sparse
