#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace isostretch::app::compare {

// What every run of a method is allowed.
struct Limits {
  double gradient_tolerance = 1e-4;
  int max_iterations = 1000;
  double time_limit = 60;   // seconds; 0: none
  double memory_limit = 0;  // megabytes; 0: none
};

struct Options {
  std::filesystem::path out;
  std::vector<std::string> methods;  // names, in the order of baselines::methods()
  Limits limits;
  int repetitions = 3;
  bool picture = true;
};

}  // namespace isostretch::app::compare
