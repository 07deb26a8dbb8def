#pragma once

#include <isostretch/sparse/solver.hpp>

#include <memory>

namespace isostretch::sparse {

// Backend::automatic: chooses a direct solver or conjugate gradients with multigrid at every analyze().
std::unique_ptr<Solver> make_automatic_solver(const Options& options);

}  // namespace isostretch::sparse
