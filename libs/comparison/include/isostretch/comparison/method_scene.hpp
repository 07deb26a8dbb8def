#pragma once

#include <isostretch/scene/comparison_limits.hpp>
#include <isostretch/scene/node.hpp>

#include <string>
#include <vector>

namespace isostretch::comparison {

/// The settings of a comparison of methods: all that its scene says besides the problems.
struct ComparisonSettings {
  std::vector<std::string> methods;  ///< names, in the order of baselines::methods()
  scene::ComparisonLimits limits;    ///< Limits of each run.
  int repetitions = 3;               ///< Runs of each method on each problem.
};

/// Returns the settings of a scene. Throws Error naming the key by its path.
ComparisonSettings read_comparison_settings(const scene::Value& scene);

/// Returns the problems of a scene: at least one, each an object with a name of its own that can name a
/// folder. Throws Error naming the key by its path. The scene must live longer.
std::vector<scene::Node> read_problem_list(const scene::Value& scene);
/// Returns the name of a problem. Throws Error where it can name no folder.
std::string problem_name(const scene::Node& problem);
/// Returns whether names of problems may have the character.
bool may_be_in_name(char c);

/// Returns the methods of these names, in the order of baselines::methods(); "all" is every one. Throws Error
/// listing those there are.
std::vector<std::string> choose_methods(const std::vector<std::string>& names);

}  // namespace isostretch::comparison
