#pragma once

#include "common/exit_code.hpp"
#include "common/option_flags.hpp"
#include "common/terminal.hpp"

#include <functional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace isostretch::app {

// Options every app has: --quiet, --verbose, --log-level, --log-file, --threads, --plugin, --version.
struct CommonOptions {
  bool quiet = false;
  bool verbose = false;
  std::optional<LogLevel> log_level;
  std::filesystem::path log_file;
  int threads = 0;                   // 0: as OpenMP likes
  std::vector<std::string> plugins;  // loaded by then

  Logging logging() const {
    return {quiet ? Verbosity::quiet : verbose ? Verbosity::verbose : Verbosity::normal, log_level, log_file};
  }
};

struct AppDescription {
  std::string name;
  std::string purpose;
  std::vector<std::string> examples;                           // of command lines, for --help
  std::vector<RenamedFlag> renamed = {};                       // flags of earlier versions
  std::function<void(CLI::App&)> declare;                      // adds the app's own options
  std::function<ExitCode(const CommonOptions& options)> body;  // the work, when they are read
};

// Parses, sets up logging, threads and interrupts, runs the body, and turns whatever is thrown into one line
// on stderr and an exit code. Never throws.
int run_app(int argc, const char* const* argv, const AppDescription& description) noexcept;

}  // namespace isostretch::app
