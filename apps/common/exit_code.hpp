#pragma once

#include <isostretch/core/error.hpp>

#include <filesystem>
#include <string>
#include <utility>

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

// An Error that knows which exit code it leads to.
class Failure : public Error {
 public:
  Failure(ExitCode code, const std::string& message) : Error(message), code_(code) {}
  ExitCode code() const noexcept { return code_; }

 private:
  ExitCode code_;
};

// Runs one phase of an app: what the libraries and the file system throw there leads to that exit code.
template <class Work>
auto failing_with(ExitCode code, Work&& work) {
  try {
    return std::forward<Work>(work)();
  } catch (const Failure&) {
    throw;
  } catch (const Error& error) {
    throw Failure(code, error.what());
  } catch (const std::filesystem::filesystem_error& error) {
    throw Failure(code, error.what());
  }
}

// Puts the name of the file in front of an Error that knows only what is wrong in it.
template <class Work>
auto naming_file(const std::filesystem::path& file, Work&& work) {
  try {
    return std::forward<Work>(work)();
  } catch (const Failure&) {
    throw;
  } catch (const Error& error) {
    throw Error(file.string() + ": " + error.what());
  }
}

}  // namespace isostretch::app
