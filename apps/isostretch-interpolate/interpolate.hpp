#pragma once

#include "command_line.hpp"
#include "common/exit_code.hpp"
#include "common/run_app.hpp"

namespace isostretch::app::interpolate {

// The whole job: read, solve frame by frame, write, report.
ExitCode interpolate(const CommandLine& command_line, const CommonOptions& common);

}  // namespace isostretch::app::interpolate
