#pragma once

#include <isostretch/core/error.hpp>
#include <isostretch/core/text.hpp>

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace isostretch {

/// What the choices of an enumeration are called, on the command line, in scenes and in summary.json.
template <class Choice, std::size_t N>
using ChoiceNames = std::array<std::pair<const char*, Choice>, N>;

/// Returns the names in their order.
template <class Choice, std::size_t N>
std::vector<std::string> all_names(const ChoiceNames<Choice, N>& names) {
  std::vector<std::string> all;
  for (const auto& [name, choice] : names) all.emplace_back(name);
  return all;
}

/// Returns the choice of that name, which must be one of these.
template <class Choice, std::size_t N>
Choice choice_of(const ChoiceNames<Choice, N>& names, const std::string& name) {
  return std::find_if(names.begin(), names.end(), [&](const auto& entry) { return entry.first == name; })
      ->second;
}

/// Returns the name of a choice, which must have one.
template <class Choice, std::size_t N>
const char* name_of(const ChoiceNames<Choice, N>& names, Choice choice) {
  return std::find_if(names.begin(), names.end(), [&](const auto& entry) { return entry.second == choice; })
      ->first;
}

/// Returns the choice of that name. Throws Error, "unknown WHAT 'NAME'; there are ...", where there is none.
template <class Choice, std::size_t N>
Choice choice_from_name(const ChoiceNames<Choice, N>& names, std::string_view name, const char* what) {
  const auto found =
      std::find_if(names.begin(), names.end(), [&](const auto& entry) { return entry.first == name; });
  if (found == names.end())
    throw Error(std::string("unknown ") + what + " '" + std::string(name) + "'; there are " +
                listed(all_names(names)));
  return found->second;
}

}  // namespace isostretch
