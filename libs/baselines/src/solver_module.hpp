#pragma once

#include "nonlinear_program.hpp"

#include <isostretch/core/error.hpp>

namespace isostretch::baselines {

// A solver's module is not there, or what it needs is not.
class ModuleError : public Error {
 public:
  using Error::Error;
};

// Loads the module NAME.so, which stays loaded, and returns its function. It is sought where the run path of
// the program or shared library says, and where the system looks for libraries: so nobody who does not ask
// for a solver loads it. Throws ModuleError saying what is missing.
SolveProgram load_solver(const char* module, const char* function);

}  // namespace isostretch::baselines
