#pragma once

#include "options.hpp"

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace isostretch::app::inspect {

// The options of this app: declared to CLI11, then read with everything that CLI11 cannot check itself.
class CommandLine {
 public:
  void declare(CLI::App& cli);

  // Throws Error naming the option at fault.
  Options options() const;

 private:
  std::string energy_, out_;
  std::string dimensions_ = "both", range_ = "0.3:3";
  std::vector<std::string> parameters_;
};

}  // namespace isostretch::app::inspect
