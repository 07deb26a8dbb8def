#pragma once

#include <string>
#include <string_view>

namespace isostretch::app {

enum class Verbosity { quiet, normal, verbose };

// Sends the log of the libraries and of the app to stderr through spdlog: errors only when quiet, debug
// messages too when verbose. Call once at the start.
void start_logging(Verbosity verbosity);

void log_debug(std::string_view message);
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
