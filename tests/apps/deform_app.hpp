#pragma once

#include "process.hpp"
#include "scratch.hpp"

#include <nlohmann/json.hpp>

#include <functional>
#include <string>
#include <vector>

namespace isostretch::test {

// isostretch-deform with these arguments.
inline Outcome deform(std::vector<std::string> arguments, const std::function<void(int)>& meanwhile = {}) {
  arguments.insert(arguments.begin(), program("deform"));
  return run(arguments, meanwhile);
}

// The end of a bar of tets turned about its axis, the other held.
inline nlohmann::ordered_json twisted_bar(double degrees, int frames) {
  return {{"mesh", {{"bar", {{"cells", {8, 2, 2}}, {"size", {4, 1, 1}}}}}},
          {"energy", "symmetric_dirichlet"},
          {"handles",
           {{{"name", "left"}, {"select", {{"slab", {{"axis", "x"}, {"end", "min"}, {"fraction", 0.05}}}}}},
            {{"name", "right"},
             {"select", {{"slab", {{"axis", "x"}, {"end", "max"}, {"fraction", 0.05}}}}},
             {"rotate", {{"axis", {1, 0, 0}}, {"degrees", degrees}}}}}},
          {"frames", frames}};
}

// Both ends of a bar held, the right one moved by so much.
inline nlohmann::ordered_json pulled_bar(const nlohmann::ordered_json& translate) {
  nlohmann::ordered_json scene = twisted_bar(0, 1);
  scene["mesh"]["bar"]["cells"] = {4, 2, 2};
  scene["handles"][1].erase("rotate");
  scene["handles"][1]["translate"] = translate;
  return scene;
}

}  // namespace isostretch::test
