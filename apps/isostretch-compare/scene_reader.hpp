#pragma once

#include "common/json_value.hpp"
#include "options.hpp"

#include <string>
#include <vector>

namespace isostretch::app::compare {

// The keys of a scene, docs/apps/compare.md explains them.
std::vector<std::string> scene_keys();

// Settings of a scene. Throws Error naming the key by its path.
Options read_options(const Json& scene);

// The problems of a scene: at least one, each an object with a name of its own that can name a folder. Throws
// Error naming the key by its path. The scene must live longer.
std::vector<JsonValue> read_problem_list(const Json& scene);
std::string problem_name(const JsonValue& problem);
bool may_be_in_name(char c);

// The methods of these names, in the order of baselines::methods(); "all" is every one. Throws Error listing
// those there are.
std::vector<std::string> choose_methods(const std::vector<std::string>& names);

// Puts the option in front of an Error that does not know it.
template <class Work>
auto naming_option(const std::string& option, Work&& work) {
  try {
    return work();
  } catch (const Error& error) {
    throw Error(option + ": " + error.what());
  }
}

}  // namespace isostretch::app::compare
