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

/// The names of the choices of an enumeration, as command lines, scenes and summary.json spell them.
template <class Choice, std::size_t N>
using ChoiceNames = std::array<std::pair<const char*, Choice>, N>;

/// Returns the names of all choices, in their order.
template <class Choice, std::size_t N>
std::vector<std::string> all_names(const ChoiceNames<Choice, N>& names) {
  std::vector<std::string> all;
  for (const auto& [name, choice] : names) all.emplace_back(name);
  return all;
}

/// Returns the choice that has this name. The name must be one of those in `names`.
template <class Choice, std::size_t N>
Choice choice_of(const ChoiceNames<Choice, N>& names, const std::string& name) {
  return std::find_if(names.begin(), names.end(), [&](const auto& entry) { return entry.first == name; })
      ->second;
}

/// Returns the name of a choice. The choice must be one of those in `names`.
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
