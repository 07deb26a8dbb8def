#pragma once

#include "options.hpp"

#include <isostretch/core/choice_names.hpp>
#include <isostretch/core/text.hpp>

namespace isostretch::app::parameterize {

inline constexpr ChoiceNames<Initial, 2> initial_names{
    {{"tutte", Initial::tutte}, {"input", Initial::input}}};
inline constexpr ChoiceNames<Boundary, 4> boundary_names{{{"free", Boundary::free},
                                                          {"fixed", Boundary::fixed},
                                                          {"circle", Boundary::circle},
                                                          {"square", Boundary::square}}};
inline constexpr ChoiceNames<Pack, 3> pack_names{
    {{"auto", Pack::automatic}, {"square", Pack::square}, {"none", Pack::none}}};
inline constexpr ChoiceNames<OverlapRule, 3> overlap_names{
    {{"auto", OverlapRule::automatic}, {"split", OverlapRule::split}, {"allow", OverlapRule::allow}}};
inline constexpr ChoiceNames<UvUnits, 4> uv_units_names{{{"auto", UvUnits::automatic},
                                                         {"square", UvUnits::square},
                                                         {"model", UvUnits::model},
                                                         {"area", UvUnits::area}}};
inline constexpr ChoiceNames<mesh::Holes, 3> holes_names{
    {{"short", mesh::Holes::keep_short}, {"none", mesh::Holes::cut_all}, {"all", mesh::Holes::keep_all}}};

}  // namespace isostretch::app::parameterize
