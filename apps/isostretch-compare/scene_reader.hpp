#pragma once

#include "options.hpp"

#include <isostretch/scene/node.hpp>

#include <string>
#include <vector>

namespace isostretch::app::compare {

using scene::Node;

// Settings of a scene. Throws Error naming the key by its path.
Options read_options(const scene::Value& scene);

// The problems of a scene: at least one, each an object with a name of its own that can name a folder. Throws
// Error naming the key by its path. The scene must live longer.
std::vector<Node> read_problem_list(const scene::Value& scene);
std::string problem_name(const Node& problem);
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
