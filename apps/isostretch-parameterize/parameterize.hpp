#pragma once

#include "common/exit_code.hpp"
#include "common/run_app.hpp"
#include "options.hpp"

namespace isostretch::app::parameterize {

// The whole job: read, start, solve, write, report.
ExitCode parameterize(const Options& options, const CommonOptions& common);

}  // namespace isostretch::app::parameterize
