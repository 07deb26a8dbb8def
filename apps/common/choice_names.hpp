#pragma once

#include <isostretch/core/text.hpp>

#include <algorithm>
#include <array>
#include <string>
#include <utility>
#include <vector>

namespace isostretch::app {

// What the choices are called, on the command line, in scenes and in summary.json.
template <class Choice, std::size_t N>
using ChoiceNames = std::array<std::pair<const char*, Choice>, N>;

template <class Choice, std::size_t N>
std::vector<std::string> all_names(const ChoiceNames<Choice, N>& names) {
  std::vector<std::string> all;
  for (const auto& [name, choice] : names) all.emplace_back(name);
  return all;
}

// The name must be one of these, and the choice have one.
template <class Choice, std::size_t N>
Choice choice_of(const ChoiceNames<Choice, N>& names, const std::string& name) {
  return std::find_if(names.begin(), names.end(), [&](const auto& entry) { return entry.first == name; })
      ->second;
}

template <class Choice, std::size_t N>
const char* name_of(const ChoiceNames<Choice, N>& names, Choice choice) {
  return std::find_if(names.begin(), names.end(), [&](const auto& entry) { return entry.second == choice; })
      ->first;
}

}  // namespace isostretch::app
