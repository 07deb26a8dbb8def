#pragma once

#include <isostretch/baselines/process.hpp>
#include <isostretch/comparison/record.hpp>
#include <isostretch/core/stop_token.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace isostretch::comparison {

/// A run of this very program in a process of its own, as comparisons are made of: it writes summary.json,
/// and what else it likes, to a folder of its own.
struct ProgramRun {
  std::vector<std::string> arguments;  ///< Arguments of the program.
  std::string identity;                ///< All that results depend on besides the program and its arguments.
  std::filesystem::path folder;        ///< Folder of the results, made anew.
  double time_limit = 0;    ///< seconds; the program heeds it, and is ended if it does not; 0: none
  double memory_limit = 0;  ///< megabytes; 0: none
};

/// The result of such a run.
struct ProgramResult {
  baselines::ProcessResult process;  ///< How the process ended.
  Record summary;                    ///< null where the program left none
  /// Without a summary a name of baselines::Status; empty otherwise.
  std::string status;
  /// Without a summary the last that the program said.
  std::string message;

  /// Returns whether the program left an account of itself.
  bool has_summary() const { return summary.is_object(); }
};

/// Returns what came of a run. One that is there already, made of the same, is not made again; one that was
/// stopped on request, or that ended by itself without results, is. Beside the results lie process.json,
/// log.txt, errors.txt and run.txt, what the run was made of. A request of `stop` ends it. Throws Error where
/// the folder cannot be written. Linux only: the program is found in /proc.
ProgramResult run_program(const ProgramRun& run, const StopToken& stop = {});

/// Returns what a file is known by to be the same: its size and the time of its last change.
std::string file_stamp(const std::filesystem::path& file);

/// Returns the content of a file; empty where there is none.
std::string text_of(const std::filesystem::path& file);

}  // namespace isostretch::comparison
