#pragma once

#include "command_line.hpp"
#include "common/exit_code.hpp"
#include "common/run_app.hpp"

namespace isostretch::app::deform {

// The whole job: read, move frame by frame, write, report.
ExitCode deform(const CommandLine& command_line, const CommonOptions& common);

}  // namespace isostretch::app::deform
