#include <isostretch/core/log.hpp>

#include <atomic>
#include <memory>
#include <mutex>
#include <utility>

namespace isostretch {
namespace {

std::mutex sink_mutex;
std::shared_ptr<const LogSink> sink;
constexpr int silent = static_cast<int>(LogLevel::error) + 1;
std::atomic<int> least_level{silent};

}  // namespace

LogSink set_log_sink(LogSink replacement, LogLevel least) {
  const std::lock_guard lock(sink_mutex);
  LogSink previous = sink ? *sink : LogSink{};
  least_level = replacement ? static_cast<int>(least) : silent;
  sink = replacement ? std::make_shared<const LogSink>(std::move(replacement)) : nullptr;
  return previous;
}

bool log_enabled(LogLevel level) noexcept {
  return static_cast<int>(level) >= least_level.load(std::memory_order_relaxed);
}

void log(LogLevel level, std::string_view message) {
  if (!log_enabled(level)) return;
  std::shared_ptr<const LogSink> current;
  {
    const std::lock_guard lock(sink_mutex);
    current = sink;
  }
  if (current) (*current)(level, message);
}

}  // namespace isostretch
