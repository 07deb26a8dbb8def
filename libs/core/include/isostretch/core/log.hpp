#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <type_traits>

namespace isostretch {

/// The importance of a message. trace: about a step of a solver; debug: how a solver proceeds; info: a user
/// may want to know; warning: a result may not be what was asked for; error: there is no result.
enum class LogLevel { trace, debug, info, warning, error };

/// A function that takes the messages of the libraries.
using LogSink = std::function<void(LogLevel, std::string_view message)>;

/// Sends messages of level `least` and above to the replacement, and returns the sink that was set before.
/// Libraries are silent until a sink is set; an empty sink silences them again. May be called from any
/// thread, but is meant for start-up: messages under way may still reach the old sink.
LogSink set_log_sink(LogSink replacement, LogLevel least = LogLevel::trace);

/// Returns whether a message of this level reaches a sink. Costs one relaxed atomic read.
bool log_enabled(LogLevel level) noexcept;

/// Sends a message to the sink, if one is set and takes this level.
void log(LogLevel level, std::string_view message);

/// Sends what `compose()` returns to the sink, and calls it only if the message reaches one.
template <class Compose>
requires std::is_invocable_v<const Compose&>
void log(LogLevel level, const Compose& compose) {
  if (log_enabled(level)) log(level, std::string_view(std::string(compose())));
}

}  // namespace isostretch
