#pragma once

#include "failure.hpp"
#include "process.hpp"
#include "scratch.hpp"

#include <nlohmann/json.hpp>

#include <functional>
#include <string>
#include <vector>

namespace isostretch::test {

// isostretch-compare with these arguments.
inline Outcome compare(std::vector<std::string> arguments, const std::function<void(int)>& meanwhile = {}) {
  arguments.insert(arguments.begin(), program("compare"));
  return run(arguments, meanwhile);
}

// isostretch-compare ends with that code, and as check_failure_of() says.
inline void check_failure(const Scratch& scratch, const std::vector<std::string>& arguments, int code,
                          const std::vector<std::string>& words) {
  check_failure_of([](const auto& list) { return compare(list); }, scratch, arguments, code, words);
}

// A face to flatten, which takes any method a moment.
inline nlohmann::ordered_json face_problem(int rings = 8) {
  return {{"name", "face"}, {"mesh", {{"face", {{"rings", rings}}}}}, {"energy", "symmetric_dirichlet"}};
}

// A bar whose ends are held, one of them turned.
inline nlohmann::ordered_json bar_problem(const std::string& energy, double degrees = 60) {
  return {{"name", "bar_" + energy},
          {"mesh", {{"bar", {{"cells", {4, 2, 2}}, {"size", {2, 1, 1}}}}}},
          {"energy", energy},
          {"handles",
           {{{"name", "left"}, {"select", {{"slab", {{"axis", "x"}, {"end", "min"}, {"fraction", 0.01}}}}}},
            {{"name", "right"},
             {"select", {{"slab", {{"axis", "x"}, {"end", "max"}, {"fraction", 0.01}}}}},
             {"rotate", {{"axis", {1, 0, 0}}, {"degrees", degrees}}}}}}};
}

inline nlohmann::ordered_json comparison_scene(const std::vector<nlohmann::ordered_json>& problems,
                                               const std::vector<std::string>& methods, int repetitions = 1) {
  return {{"problems", problems}, {"methods", methods}, {"repetitions", repetitions}};
}

}  // namespace isostretch::test
