#pragma once

#include <isostretch/comparison/method_scene.hpp>

#include <filesystem>

namespace isostretch::app::compare {

struct Options : comparison::ComparisonSettings {
  std::filesystem::path out;
  bool picture = true;
};

}  // namespace isostretch::app::compare
