#include "common/exit_code.hpp"

#include <algorithm>

namespace isostretch::app {

std::string exit_code_help() {
  return "Exit codes:\n"
         "  0  success\n"
         "  1  internal error, or out of memory\n"
         "  2  wrong command line\n"
         "  3  input unreadable or not usable\n"
         "  4  output cannot be written\n"
         "  5  stopped early (iterations, time, Ctrl-C); the best state is written\n"
         "  6  the solver failed, or elements are flipped; the best state is written";
}

ExitCode exit_code_of(ErrorKind kind) noexcept {
  switch (kind) {
    case ErrorKind::misuse:
      return ExitCode::command_line;
    case ErrorKind::input:
      return ExitCode::input;
    case ErrorKind::resource:
      return ExitCode::output;
    case ErrorKind::stopped:
      return ExitCode::not_converged;
    case ErrorKind::unsolved:
      break;
  }
  return ExitCode::solver_failed;
}

ExitCode exit_code_of(reports::RunStatus status) noexcept {
  if (status == reports::RunStatus::failed) return ExitCode::solver_failed;
  return status == reports::RunStatus::success ? ExitCode::success : ExitCode::not_converged;
}

std::string error_text(const Error& error) {
  if (const auto* about_option = dynamic_cast<const OptionError*>(&error)) {
    std::string flag = about_option->option();
    std::replace(flag.begin(), flag.end(), '_', '-');
    return "--" + flag + ": " + about_option->text();
  }
  const bool nothing = error.kind() == ErrorKind::stopped || error.kind() == ErrorKind::unsolved;
  return std::string(error.what()) + (nothing ? "; nothing is written" : "");
}

}  // namespace isostretch::app
