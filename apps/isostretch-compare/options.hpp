#pragma once

#include <isostretch/scene/comparison_limits.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace isostretch::app::compare {

using Limits = scene::ComparisonLimits;

struct Options {
  std::filesystem::path out;
  std::vector<std::string> methods;  // names, in the order of baselines::methods()
  Limits limits;
  int repetitions = 3;
  bool picture = true;
};

}  // namespace isostretch::app::compare
