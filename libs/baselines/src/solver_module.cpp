#include "solver_module.hpp"

#include <dlfcn.h>

#include <string>

namespace isostretch::baselines {

SolveProgram load_solver(const char* module, const char* function) {
  void* library = dlopen((std::string(module) + ".so").c_str(), RTLD_NOW | RTLD_LOCAL);
  if (library == nullptr)
    throw ModuleError(std::string("the module of this solver cannot be loaded: ") + dlerror());
  void* symbol = dlsym(library, function);
  if (symbol == nullptr)
    throw ModuleError(std::string("the module of this solver is of another version: ") + dlerror());
  return reinterpret_cast<SolveProgram>(symbol);
}

}  // namespace isostretch::baselines
