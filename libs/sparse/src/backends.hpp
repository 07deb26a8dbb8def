#pragma once

#include <isostretch/sparse/solver.hpp>

#include <memory>

namespace isostretch::sparse {

// The solver that was registered as options.backend; null for a back end that is built in.
std::unique_ptr<Solver> make_registered_solver(const Options& options);

}  // namespace isostretch::sparse
