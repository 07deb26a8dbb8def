#pragma once

#include "process.hpp"
#include "scratch.hpp"

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace isostretch::test {

// isostretch-manipulate with these arguments.
inline Outcome manipulate(std::vector<std::string> arguments,
                          const std::function<void(int)>& meanwhile = {}) {
  arguments.insert(arguments.begin(), program("manipulate"));
  return run(arguments, meanwhile);
}

// A square whose boundary is held while a patch in its middle turns.
inline nlohmann::ordered_json swirl(double degrees, int cells = 8, int frames = 1) {
  return {{"mesh", {{"grid", {{"cells", {cells, cells}}}}}},
          {"handles",
           {{{"name", "boundary"}, {"select", {{"patch", {{"point", {0, 0}}, {"distance", 10}}}}}},
            {{"name", "middle"},
             {"select", {{"sphere", {{"center", {0.5, 0.5}}, {"radius", 0.13}}}}},
             {"rotate", {{"degrees", degrees}}}}}},
          {"frames", frames}};
}

// The right end of a bar of tets is pushed through the left one.
inline nlohmann::ordered_json squashed_bar() {
  return {{"mesh", {{"bar", {{"cells", {6, 2, 2}}, {"size", {3, 1, 1}}}}}},
          {"handles",
           {{{"name", "left"}, {"select", {{"slab", {{"axis", "x"}, {"end", "min"}, {"fraction", 0.01}}}}}},
            {{"name", "right"},
             {"select", {{"slab", {{"axis", "x"}, {"end", "max"}, {"fraction", 0.01}}}}},
             {"rotate", {{"axis", {1, 0, 0}}, {"degrees", 45}}},
             {"translate", {-3.4, 1.2, 0}}}}}};
}

}  // namespace isostretch::test
