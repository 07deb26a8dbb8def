#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace isostretch::baselines {

/// A program to run: directly, without a shell, with nothing to read on its standard input.
struct Command {
  std::string program;                 ///< a path, or a name to look for in PATH
  std::vector<std::string> arguments;  ///< without the name of the program itself
  std::filesystem::path folder;        ///< where it runs; empty: where the caller does
  std::vector<std::pair<std::string, std::string>> environment;  ///< on top of the caller's
  /// Files for its standard output and errors, relative to `folder`; empty: kept in the ProcessResult.
  /// File for standard output; empty: it is kept in the result.
  std::filesystem::path output_file = {};
  /// File for standard error; empty: it is kept in the result.
  std::filesystem::path errors_file = {};
};

/// The limits of a program.
struct ProcessLimits {
  double seconds = 0;    ///< wall clock; 0: none
  double megabytes = 0;  ///< address space of each of its processes; 0: none
};

/// How a program ended.
struct ProcessResult {
  int exit_code = -1;      ///< -1: ended by a signal
  int signal = 0;          ///< that ended it; 0: it ended by itself
  bool timed_out = false;  ///< ended here for ProcessLimits::seconds
  bool stopped = false;    ///< ended here because the caller said so
  double seconds = 0;      ///< wall clock
  /// Largest resident set, of the program and those that it has waited for; where the caller's own is larger,
  /// of the program alone, looked at now and then.
  double peak_megabytes = 0;
  /// Standard output, unless it went to a file.
  std::string output;
  /// Standard error, unless it went to a file.
  std::string errors;

  /// Returns whether its exit code is 0.
  bool ended_well() const { return exit_code == 0; }
  /// Returns whether a signal has ended it that was not sent here.
  bool crashed() const { return signal != 0 && !timed_out && !stopped; }
};

/// Asked some twenty times a second; false ends the program.
using MayGoOn = std::function<bool()>;

/// Runs a program in a process group of its own and returns when it has ended.
///
/// At a limit, or when may_go_on says so, the group gets SIGTERM, and SIGKILL two seconds later; what a
/// program leaves behind in its group when it ends is killed too, and the program when the calling thread
/// ends. Signals of the terminal reach the caller alone, which is to pass them on through may_go_on. The
/// caller may have threads. Throws Error where the program cannot be started, naming it and the system's
/// reason; what then happens to it is in the result.
ProcessResult run_process(const Command& command, const ProcessLimits& limits = {},
                          const MayGoOn& may_go_on = {});

/// Returns the executable file of a program's name by the caller's PATH; empty where there is none.
std::filesystem::path find_program(const std::string& name);

}  // namespace isostretch::baselines
