#pragma once

#include "common/output_folder.hpp"

#include <isostretch/baselines/process.hpp>

#include <nlohmann/json.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace isostretch::app {

// A run of this very program in a process of its own, as comparisons are made of: it writes summary.json, and
// what else it likes, to a folder of its own.
struct ProgramRun {
  std::vector<std::string> arguments;
  std::string identity;  // what results depend on besides the program and its arguments
  std::filesystem::path folder;
  double time_limit = 0;    // seconds; the program heeds it, and is ended if it does not; 0: none
  double memory_limit = 0;  // megabytes; 0: none
};

struct ProgramResult {
  baselines::ProcessResult process;
  Json summary;  // null where the program left none
  // Without a summary: a name of baselines::Status, and the last that the program said.
  std::string status, message;

  bool has_summary() const { return summary.is_object(); }
};

// What came of it. A run that is there already, made of the same, is not made again; one that Ctrl-C ended,
// or that ended by itself without results, is. Beside the results lie process.json, log.txt, errors.txt and
// run.txt, what the run was made of. Throws Error where the folder cannot be written.
ProgramResult run_program(const ProgramRun& run);

// By which a file is known to be the same: size and time of the last change.
std::string file_stamp(const std::filesystem::path& file);

// Of a file; empty where there is none. A run's JSON is null where there is none or it is cut off.
std::string text_of(const std::filesystem::path& file);
Json json_of(const std::filesystem::path& file);

}  // namespace isostretch::app
