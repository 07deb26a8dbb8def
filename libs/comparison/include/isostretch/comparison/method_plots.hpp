#pragma once

#include <isostretch/comparison/method_comparison.hpp>

#include <string>
#include <vector>

namespace isostretch::comparison {

/// A picture in two formats.
struct NamedPicture {
  std::string name;  ///< Name of the file, without its ending.
  std::string png;   ///< Bytes of the PNG.
  std::string svg;   ///< Text of the SVG.
};

/// Returns a picture of every problem, in order, and with two problems or more the performance profiles.
std::vector<NamedPicture> draw_all(const MethodComparison& comparison);

}  // namespace isostretch::comparison
