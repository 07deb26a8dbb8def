#pragma once

#include "command_line.hpp"
#include "common/exit_code.hpp"
#include "common/run_app.hpp"

namespace isostretch::app::manipulate {

// Runs many solvers on the last frame of the scene, each alone in a process of its own, and writes how they
// compare. What is there already from a run of the same scene with the same limits is not made again.
ExitCode compare(const CommandLine& command_line, const CommonOptions& common);

}  // namespace isostretch::app::manipulate
