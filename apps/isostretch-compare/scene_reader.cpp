#include "scene_reader.hpp"

#include <isostretch/baselines/distortion.hpp>

#include <algorithm>
#include <cctype>
#include <set>

namespace isostretch::app::compare {
namespace {

double not_negative(const JsonValue& value) {
  const double number = value.number();
  if (number < 0) value.fail("must not be negative");
  return number;
}

// Megabytes of address space that a process takes before it has read anything; BLAS libraries wait forever
// where they do not get theirs.
constexpr double least_memory_limit = 256;

double read_memory_limit(const JsonValue& value) {
  const double limit = not_negative(value);
  if (limit > 0 && limit < least_memory_limit)
    value.fail("must be 0 (none) or at least 256, which a process takes before it has read anything");
  return limit;
}

std::vector<std::string> texts(const JsonValue& list) {
  std::vector<std::string> all;
  for (const JsonValue& item : list.items()) all.push_back(item.text());
  return all;
}

}  // namespace

std::vector<std::string> scene_keys() {
  return {"problems",   "methods",      "gradient_tolerance", "max_iterations",
          "time_limit", "memory_limit", "repetitions"};
}

Options read_options(const Json& json) {
  const JsonValue scene(json);
  scene.only(scene_keys());
  Options options;
  options.methods = choose_methods({"all"});
  if (const auto methods = scene.find("methods"))
    options.methods = naming(*methods, [&] { return choose_methods(texts(*methods)); });
  Limits& limits = options.limits;
  if (const auto value = scene.find("gradient_tolerance")) limits.gradient_tolerance = not_negative(*value);
  if (const auto value = scene.find("max_iterations")) limits.max_iterations = value->whole(0, 1'000'000'000);
  if (const auto value = scene.find("time_limit")) limits.time_limit = not_negative(*value);
  if (const auto value = scene.find("memory_limit")) limits.memory_limit = read_memory_limit(*value);
  if (const auto value = scene.find("repetitions")) options.repetitions = value->whole(1, 1000);
  return options;
}

std::vector<JsonValue> read_problem_list(const Json& scene) {
  const JsonValue list = JsonValue(scene).at("problems");
  const std::vector<JsonValue> problems = list.items();
  if (problems.empty()) list.fail("there must be one at least");
  std::set<std::string> names;
  for (const JsonValue& problem : problems)
    if (!names.insert(problem_name(problem)).second)
      problem.at("name").fail("the name '" + problem_name(problem) + "' is taken");
  return problems;
}

bool may_be_in_name(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '-' || c == '.';
}

std::string problem_name(const JsonValue& problem) {
  const JsonValue value = problem.at("name");
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

}  // namespace isostretch::app::compare
