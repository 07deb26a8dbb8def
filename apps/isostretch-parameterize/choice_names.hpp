#pragma once

#include "options.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <utility>
#include <vector>

namespace isostretch::app::parameterize {

// What the choices are called, on the command line and in summary.json.
template <class Choice, std::size_t N>
using ChoiceNames = std::array<std::pair<const char*, Choice>, N>;

inline constexpr ChoiceNames<Initial, 2> initial_names{
    {{"tutte", Initial::tutte}, {"input", Initial::input}}};
inline constexpr ChoiceNames<Boundary, 4> boundary_names{{{"free", Boundary::free},
                                                          {"fixed", Boundary::fixed},
                                                          {"circle", Boundary::circle},
                                                          {"square", Boundary::square}}};
inline constexpr ChoiceNames<Pack, 3> pack_names{
    {{"auto", Pack::automatic}, {"square", Pack::square}, {"none", Pack::none}}};
inline constexpr ChoiceNames<mesh::Holes, 3> holes_names{
    {{"short", mesh::Holes::keep_short}, {"none", mesh::Holes::cut_all}, {"all", mesh::Holes::keep_all}}};

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

}  // namespace isostretch::app::parameterize
