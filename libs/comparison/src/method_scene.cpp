#include <isostretch/baselines/distortion.hpp>
#include <isostretch/comparison/method_scene.hpp>
#include <isostretch/core/text.hpp>
#include <isostretch/scene/option_values.hpp>

#include <algorithm>
#include <cctype>
#include <set>

namespace isostretch::comparison {

using scene::Node;

namespace {

// Megabytes of address space that a process takes before it has read anything; BLAS libraries wait forever
// where they do not get theirs.
constexpr double least_memory_limit = 256;

void check_memory_limit(const Node& scene, double limit) {
  if (limit > 0 && limit < least_memory_limit)
    scene.at("limits")
        .at("memory_limit")
        .fail("must be 0 (none) or at least 256, which a process takes before it has read anything");
}

std::vector<std::string> texts(const Node& list) {
  std::vector<std::string> all;
  for (const Node& item : list.items()) all.push_back(item.text());
  return all;
}

}  // namespace

ComparisonSettings read_comparison_settings(const scene::Value& value) {
  const Node scene(value);
  ComparisonSettings settings;
  settings.methods = choose_methods({"all"});
  if (const auto methods = scene.find("methods"))
    settings.methods = naming(*methods, [&] { return choose_methods(texts(*methods)); });
  if (const auto limits = scene.find("limits")) scene::read_options(*limits, settings.limits);
  check_memory_limit(scene, settings.limits.memory_limit);
  if (const auto count = scene.find("repetitions")) settings.repetitions = count->whole(1, 1000);
  return settings;
}

std::vector<Node> read_problem_list(const scene::Value& scene) {
  const Node list = Node(scene).at("problems");
  const std::vector<Node> problems = list.items();
  if (problems.empty()) list.fail("there must be one at least");
  std::set<std::string> names;
  for (const Node& problem : problems)
    if (!names.insert(problem_name(problem)).second)
      problem.at("name").fail("the name '" + problem_name(problem) + "' is taken");
  return problems;
}

bool may_be_in_name(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '-' || c == '.';
}

std::string problem_name(const Node& problem) {
  const Node value = problem.at("name");
  const std::string name = value.text();
  if (name.empty() || name.front() == '.' || !std::all_of(name.begin(), name.end(), may_be_in_name))
    value.fail("'" + name + "' names a folder: letters, digits, _, - and ., not at first");
  if (name == "profiles") value.fail("'profiles' is what the plots of all problems are called");
  return name;
}

std::vector<std::string> choose_methods(const std::vector<std::string>& names) {
  std::vector<std::string> all, chosen;
  for (const baselines::MethodInfo& info : baselines::methods()) all.emplace_back(info.name);
  const auto among = [](const std::vector<std::string>& list, const std::string& name) {
    return std::find(list.begin(), list.end(), name) != list.end();
  };
  for (const std::string& name : names)
    if (name != "all" && !among(all, name))
      throw Error("there is no method '" + name + "'; there are all, " + listed(all));
  for (const std::string& name : all)
    if (among(names, "all") || among(names, name)) chosen.push_back(name);
  if (chosen.empty()) throw Error("there must be one at least");
  return chosen;
}

}  // namespace isostretch::comparison
