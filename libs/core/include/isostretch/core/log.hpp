#pragma once

#include <functional>
#include <string>
#include <string_view>

namespace isostretch {

enum class LogLevel { debug, info, warning, error };

using LogSink = std::function<void(LogLevel, std::string_view message)>;

// Libraries are silent until a sink is set. Returns the previous sink; an empty sink silences again.
// Safe to call from any thread, but meant for start-up: messages under way may still reach the old sink.
LogSink set_log_sink(LogSink sink);

// True when a sink is set: lets a caller skip the work of composing a message nobody reads.
bool log_enabled() noexcept;

void log(LogLevel level, std::string_view message);

}  // namespace isostretch
