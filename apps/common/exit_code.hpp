#pragma once

#include <isostretch/core/error.hpp>
#include <isostretch/reports/run_status.hpp>

#include <string>

namespace isostretch::app {

// What every app returns to the shell; docs/apps/exit_codes.md explains them to users.
enum class ExitCode {
  success = 0,
  internal_error = 1,
  command_line = 2,
  input = 3,
  output = 4,
  not_converged = 5,
  solver_failed = 6
};

// The table of exit codes, for the end of --help.
std::string exit_code_help();

/// Returns the exit code for an error that ends a program.
ExitCode exit_code_of(ErrorKind kind) noexcept;

/// Returns the exit code for a run that ended like that.
ExitCode exit_code_of(reports::RunStatus status) noexcept;

/// Returns what to say about it: an option by its flag, and that nothing came of the run where that is so.
std::string error_text(const Error& error);

}  // namespace isostretch::app
