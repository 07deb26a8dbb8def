#pragma once

#include <isostretch/scene/value.hpp>

#include <string>
#include <vector>

namespace isostretch::app::parameterize {

/// Pins and lines as the command line gives them.
struct PinTexts {
  std::vector<std::string> hard;                  ///< VERTEX or VERTEX:U,V
  std::vector<std::string> soft;                  ///< VERTEX:U,V or VERTEX:U,V:WEIGHT
  std::vector<std::string> horizontal, vertical;  ///< A,B[,C...]
  std::string corners;                            ///< A,B,C,D
};

/// Puts them into "pins", "aligned" and "corners" of "parameterization" in a scene. Throws Error naming the
/// option and the text that is none of these.
void add_pins(const PinTexts& texts, scene::Value& scene);

}  // namespace isostretch::app::parameterize
