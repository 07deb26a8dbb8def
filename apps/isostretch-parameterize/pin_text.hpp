#pragma once

#include "options.hpp"

#include <string>
#include <vector>

namespace isostretch::app::parameterize {

// VERTEX or VERTEX:U,V, and VERTEX:U,V or VERTEX:U,V:WEIGHT. Throw Error naming the text that is neither, and
// a vertex that is pinned hard twice.
std::vector<Pin> parse_pins(const std::vector<std::string>& texts);
std::vector<SoftPin> parse_soft_pins(const std::vector<std::string>& texts);

}  // namespace isostretch::app::parameterize
