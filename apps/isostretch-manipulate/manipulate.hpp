#pragma once

#include "command_line.hpp"
#include "common/exit_code.hpp"
#include "common/run_app.hpp"

namespace isostretch::app::manipulate {

// The whole job: read, solve every frame, write, report.
ExitCode manipulate(const CommandLine& command_line, const CommonOptions& common);

}  // namespace isostretch::app::manipulate
