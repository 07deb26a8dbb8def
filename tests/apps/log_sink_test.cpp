// What the libraries say goes to a logger that a program has anyway.
#include <isostretch/core/log.hpp>

#include <doctest/doctest.h>
#include <spdlog/logger.h>
#include <spdlog/sinks/ostream_sink.h>

#include <memory>
#include <sstream>

namespace {

void connect(const std::shared_ptr<spdlog::logger>& logger) {
  // snippet: README.md
  isostretch::set_log_sink([logger](isostretch::LogLevel level, std::string_view message) {
    logger->log(static_cast<spdlog::level::level_enum>(level), "{}", message);
  });
  // end of snippet
}

}  // namespace

TEST_CASE("a consumer's spdlog logger gets every message at its level") {
  std::ostringstream written;
  const auto logger =
      std::make_shared<spdlog::logger>("mine", std::make_shared<spdlog::sinks::ostream_sink_st>(written));
  logger->set_pattern("%l %v");
  logger->set_level(spdlog::level::trace);
  connect(logger);
  using isostretch::LogLevel;
  for (const LogLevel level :
       {LogLevel::trace, LogLevel::debug, LogLevel::info, LogLevel::warning, LogLevel::error})
    isostretch::log(level, "{message}");
  isostretch::set_log_sink({});
  CHECK(written.str() ==
        "trace {message}\ndebug {message}\ninfo {message}\nwarning {message}\nerror {message}\n");
}
