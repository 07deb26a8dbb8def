#pragma once

#include <isostretch/sparse/solver.hpp>

#include <memory>

namespace isostretch::sparse {

// The direct back end that options.backend names, or the preferred one when it names none.
std::unique_ptr<Solver> make_direct_solver(const Options& options);

}  // namespace isostretch::sparse
