#pragma once

#include "common/exit_code.hpp"
#include "common/run_app.hpp"
#include "options.hpp"

#include <isostretch/energies/any_energy.hpp>

namespace isostretch::app::parameterize {

// The whole job: read, start, solve, write, report.
ExitCode parameterize(const Options& options, const energies::AnyEnergy& energy, const CommonOptions& common);

}  // namespace isostretch::app::parameterize
