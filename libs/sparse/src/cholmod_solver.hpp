#pragma once

#include <isostretch/sparse/solver.hpp>

namespace isostretch::sparse {

std::unique_ptr<Solver> make_cholmod_solver(const Options& options);

}  // namespace isostretch::sparse
