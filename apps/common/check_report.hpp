#pragma once

#include "common/deformation_names.hpp"

#include "common/exit_code.hpp"

namespace isostretch::app {

/// Prints the text and the verdict, and returns the exit code: success, or input for a body in trouble.
ExitCode print_check(const deformation::SolidCheck& check);

}  // namespace isostretch::app
