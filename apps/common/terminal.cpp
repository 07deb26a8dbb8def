#include "common/terminal.hpp"

#include <isostretch/core/error.hpp>

#include <spdlog/sinks/basic_file_sink.h>
#include <spdlog/sinks/stdout_color_sinks.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <cstdio>
#include <iostream>
#include <memory>
#include <utility>

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

constexpr std::pair<const char*, LogLevel> levels[] = {{"trace", LogLevel::trace},
                                                       {"debug", LogLevel::debug},
                                                       {"info", LogLevel::info},
                                                       {"warning", LogLevel::warning},
                                                       {"error", LogLevel::error}};

LogLevel level_on_terminal(const Logging& logging) {
  if (logging.level) return *logging.level;
  if (logging.verbosity == Verbosity::quiet) return LogLevel::error;
  return logging.verbosity == Verbosity::verbose ? LogLevel::debug : LogLevel::info;
}

spdlog::level::level_enum spdlog_level(LogLevel level) {
  switch (level) {
    case LogLevel::trace:
      return spdlog::level::trace;
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

LogLevel level_in_file(const Logging& logging) {
  return logging.level.value_or(LogLevel::debug);
}

spdlog::sink_ptr file_sink(const Logging& logging) {
  try {
    const auto sink = std::make_shared<spdlog::sinks::basic_file_sink_mt>(logging.file.string(), true);
    sink->set_level(spdlog_level(level_in_file(logging)));
    sink->set_pattern("%Y-%m-%d %H:%M:%S.%e %l: %v");
    return sink;
  } catch (const spdlog::spdlog_ex&) {
    throw Error(logging.file.string() + ": cannot be written");
  }
}

void write(spdlog::level::level_enum level, std::string_view message) {
  if (!terminal().logger) start_logging({});
  if (!terminal().logger->should_log(level)) return;
  clear_progress();
  terminal().logger->log(level, "{}", message);
}

}  // namespace

void start_logging(const Logging& logging) {
  Terminal& out = terminal();
  LogLevel least = level_on_terminal(logging);
  const auto on_terminal = std::make_shared<spdlog::sinks::stderr_color_sink_mt>();
  on_terminal->set_level(spdlog_level(least));
  on_terminal->set_pattern("%^%l%$: %v");
  out.logger = std::make_shared<spdlog::logger>("app", on_terminal);
  if (!logging.file.empty()) {
    out.logger->sinks().push_back(file_sink(logging));
    least = std::min(least, level_in_file(logging));
  }
  out.logger->set_level(spdlog_level(least));
  out.quiet = logging.verbosity == Verbosity::quiet;
  out.progress = !out.quiet && ::isatty(STDERR_FILENO) == 1;
  set_log_sink([](LogLevel level, std::string_view message) { write(spdlog_level(level), message); }, least);
}

std::vector<std::string> log_level_names() {
  std::vector<std::string> names;
  for (const auto& [name, level] : levels) names.emplace_back(name);
  return names;
}

LogLevel log_level_from_name(const std::string& wanted) {
  for (const auto& [name, level] : levels)
    if (wanted == name) return level;
  throw Error("unknown level '" + wanted + "' of messages");
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
