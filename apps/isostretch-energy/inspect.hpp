#pragma once

#include "command_line.hpp"
#include "common/exit_code.hpp"
#include "common/run_app.hpp"

namespace isostretch::app::inspect {

// The whole job: read, look at the energy, report.
ExitCode inspect(const CommandLine& command_line, const CommonOptions& common);

}  // namespace isostretch::app::inspect
