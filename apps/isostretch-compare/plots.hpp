#pragma once

#include "comparison.hpp"

#include <string>
#include <vector>

namespace isostretch::app::compare {

struct NamedPicture {
  std::string name;  // of the file, without its ending
  std::string png, svg;
};

// One of every problem, in order, and with two problems or more the performance profiles.
std::vector<NamedPicture> draw_all(const Comparison& comparison);

}  // namespace isostretch::app::compare
