#include "common/terminal.hpp"

#include <isostretch/core/log.hpp>

#include <spdlog/sinks/stdout_color_sinks.h>
#include <spdlog/spdlog.h>

#include <cstdio>
#include <iostream>
#include <memory>

#include <unistd.h>

namespace isostretch::app {
namespace {

struct Terminal {
  std::shared_ptr<spdlog::logger> logger;
  bool quiet = false;
  bool progress = false;
  std::size_t shown = 0;  // columns the progress line takes
};

Terminal& terminal() {
  static Terminal instance;
  return instance;
}

spdlog::level::level_enum threshold(Verbosity verbosity) {
  if (verbosity == Verbosity::quiet) return spdlog::level::err;
  return verbosity == Verbosity::verbose ? spdlog::level::debug : spdlog::level::info;
}

spdlog::level::level_enum spdlog_level(LogLevel level) {
  switch (level) {
    case LogLevel::debug:
      return spdlog::level::debug;
    case LogLevel::info:
      return spdlog::level::info;
    case LogLevel::warning:
      return spdlog::level::warn;
    case LogLevel::error:
      break;
  }
  return spdlog::level::err;
}

void write(spdlog::level::level_enum level, std::string_view message) {
  if (!terminal().logger) start_logging(Verbosity::normal);
  if (!terminal().logger->should_log(level)) return;
  clear_progress();
  terminal().logger->log(level, "{}", message);
}

}  // namespace

void start_logging(Verbosity verbosity) {
  Terminal& out = terminal();
  out.logger =
      std::make_shared<spdlog::logger>("app", std::make_shared<spdlog::sinks::stderr_color_sink_mt>());
  out.logger->set_pattern("%^%l%$: %v");
  out.logger->set_level(threshold(verbosity));
  out.quiet = verbosity == Verbosity::quiet;
  out.progress = !out.quiet && ::isatty(STDERR_FILENO) == 1;
  set_log_sink([](LogLevel level, std::string_view message) { write(spdlog_level(level), message); });
}

void log_debug(std::string_view message) {
  write(spdlog::level::debug, message);
}
void notice(std::string_view message) {
  write(spdlog::level::info, message);
}
void warn(std::string_view message) {
  write(spdlog::level::warn, message);
}
void report_error(std::string_view message) {
  write(spdlog::level::err, message);
}

void show_progress(const std::string& line) {
  Terminal& out = terminal();
  if (!out.progress) return;
  const std::size_t blanks = line.size() < out.shown ? out.shown - line.size() : 0;
  std::fprintf(stderr, "\r%s%*s", line.c_str(), static_cast<int>(blanks), "");
  std::fflush(stderr);
  out.shown = line.size();
}

void clear_progress() {
  Terminal& out = terminal();
  if (out.shown == 0) return;
  std::fprintf(stderr, "\r%*s\r", static_cast<int>(out.shown), "");
  std::fflush(stderr);
  out.shown = 0;
}

void print(std::string_view text) {
  if (terminal().quiet) return;
  clear_progress();
  std::cout << text << std::flush;
}

}  // namespace isostretch::app
