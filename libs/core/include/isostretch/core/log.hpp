#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <type_traits>

namespace isostretch {

/// How much a message matters. trace: once a step of a solver; debug: how a solver goes about it; info: what
/// a user may want to know; warning: a result may not be what was asked for; error: there is none.
enum class LogLevel { trace, debug, info, warning, error };

using LogSink = std::function<void(LogLevel, std::string_view message)>;

/// Sends messages of `least` and above to the replacement, and returns the sink before. Libraries are silent
/// until a sink is set; an empty sink silences them again. Safe to call from any thread, but meant for
/// start-up: messages under way may still reach the old sink.
LogSink set_log_sink(LogSink replacement, LogLevel least = LogLevel::trace);

/// Returns whether a message of this level reaches anybody. Costs one relaxed atomic read.
bool log_enabled(LogLevel level) noexcept;

void log(LogLevel level, std::string_view message);

/// Logs what `compose()` returns, and calls it only where the message reaches somebody.
template <class Compose>
requires std::is_invocable_v<const Compose&>
void log(LogLevel level, const Compose& compose) {
  if (log_enabled(level)) log(level, std::string_view(std::string(compose())));
}

}  // namespace isostretch
