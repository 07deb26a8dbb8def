#pragma once

#include <isostretch/core/choice_names.hpp>
#include <isostretch/core/text.hpp>
#include <isostretch/inspection/study.hpp>

#include <filesystem>
#include <map>
#include <string>

namespace isostretch::app::inspect {

enum class Dimensions { two = 2, three = 3, both };
inline constexpr ChoiceNames<Dimensions, 3> dimension_names{
    {{"2", Dimensions::two}, {"3", Dimensions::three}, {"both", Dimensions::both}}};

using Range = inspection::StretchRange;

struct Options {
  std::string energy;  // a name or an expression
  std::map<std::string, double> parameters;
  Dimensions dimensions = Dimensions::both;  // both: those that there are
  Range range;
  std::filesystem::path out;  // empty: nothing is written
};

}  // namespace isostretch::app::inspect
