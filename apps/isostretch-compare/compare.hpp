#pragma once

#include "command_line.hpp"
#include "common/exit_code.hpp"
#include "common/run_app.hpp"

namespace isostretch::app::compare {

// Runs all methods on all problems, each in a process of its own, again and again, and writes how they
// compare. What is there already from a run of the same is not made again.
ExitCode compare(const CommandLine& command_line, const CommonOptions& common);

}  // namespace isostretch::app::compare
