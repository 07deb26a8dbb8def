#pragma once

#include "programs.hpp"

#include <functional>
#include <string>
#include <vector>

namespace isostretch::test {

struct Outcome {
  int code = -1;  // exit code; minus the signal that ended the program
  std::string out, err;
};

// Runs a program without a shell and waits for it. `meanwhile` is called with its process id once it runs.
Outcome run(const std::vector<std::string>& command, const std::function<void(int)>& meanwhile = {});

// isostretch-parameterize with these arguments.
Outcome parameterize(std::vector<std::string> arguments, const std::function<void(int)>& meanwhile = {});

}  // namespace isostretch::test
