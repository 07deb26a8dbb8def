#pragma once

#include <isostretch/core/log.hpp>

#include <string>
#include <utility>

namespace isostretch::mesh::test {

// What the library says while this lives.
class LogLines {
 public:
  LogLines()
      : previous_(
            set_log_sink([this](LogLevel, std::string_view message) { text_.append(message) += '\n'; })) {}
  ~LogLines() { set_log_sink(std::move(previous_)); }
  LogLines(const LogLines&) = delete;
  LogLines& operator=(const LogLines&) = delete;

  const std::string& text() const { return text_; }

 private:
  std::string text_;
  LogSink previous_;
};

}  // namespace isostretch::mesh::test
