#include <isostretch/core/log.hpp>

#include <atomic>
#include <memory>
#include <mutex>
#include <utility>

namespace isostretch {
namespace {

std::mutex sink_mutex;
std::shared_ptr<const LogSink> sink;
std::atomic<bool> sink_set{false};

}  // namespace

LogSink set_log_sink(LogSink replacement) {
  const std::lock_guard lock(sink_mutex);
  LogSink previous = sink ? *sink : LogSink{};
  sink_set = static_cast<bool>(replacement);
  sink = replacement ? std::make_shared<const LogSink>(std::move(replacement)) : nullptr;
  return previous;
}

bool log_enabled() noexcept {
  return sink_set.load(std::memory_order_relaxed);
}

void log(LogLevel level, std::string_view message) {
  if (!log_enabled()) return;
  std::shared_ptr<const LogSink> current;
  {
    const std::lock_guard lock(sink_mutex);
    current = sink;
  }
  if (current) (*current)(level, message);
}

}  // namespace isostretch
