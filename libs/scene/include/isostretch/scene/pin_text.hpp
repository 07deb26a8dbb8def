#pragma once

#include <isostretch/scene/value.hpp>

#include <string>
#include <vector>

namespace isostretch::scene {

/// Pins and lines as the command line gives them.
struct PinTexts {
  std::vector<std::string> hard;        ///< Hard pins, VERTEX or VERTEX:U,V.
  std::vector<std::string> soft;        ///< Soft pins, VERTEX:U,V or VERTEX:U,V:WEIGHT.
  std::vector<std::string> horizontal;  ///< Horizontal lines, A,B[,C...].
  std::vector<std::string> vertical;    ///< Vertical lines, A,B[,C...].
  std::string corners;                  ///< Corners of the square, A,B,C,D; empty for none.
};

/// Puts pins and lines into "pins", "aligned" and "corners" of "parameterization" in a scene. Throws Error
/// naming the option and the text that is none of these.
void add_pins(const PinTexts& texts, Value& scene);

}  // namespace isostretch::scene
