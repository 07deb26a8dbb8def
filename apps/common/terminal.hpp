#pragma once

#include <isostretch/core/log.hpp>

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace isostretch::app {

enum class Verbosity { quiet, normal, verbose };

/// Where messages of the app and of the libraries go.
struct Logging {
  Verbosity verbosity = Verbosity::normal;
  /// On stderr, from this level on; unset: errors when quiet, debug messages and above when verbose, else
  /// notices.
  std::optional<LogLevel> level;
  /// Gets all messages of debug level and above, or of `level` and above if that is set, with time; empty:
  /// none.
  std::filesystem::path file;
};

/// Sends the log of the libraries and of the app to stderr, and to the file, through spdlog. To call once at
/// the start. Throws Error naming the file when it cannot be written.
void start_logging(const Logging& logging);

/// Returns the levels by name: trace, debug, info, warning, error.
std::vector<std::string> log_level_names();
LogLevel log_level_from_name(const std::string& name);

void notice(std::string_view message);
void warn(std::string_view message);
void report_error(std::string_view message);

// One line on stderr that is written over and over. Silent unless stderr is a terminal and the app is not
// quiet. Log messages take the line away first.
void show_progress(const std::string& line);
void clear_progress();

// Results for the reader, on stdout; nothing when quiet.
void print(std::string_view text);

}  // namespace isostretch::app
