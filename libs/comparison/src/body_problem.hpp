#pragma once

#include <isostretch/comparison/problem.hpp>

namespace isostretch::comparison {

// A body with hard handles, scaled to volume (area in the plane) 1. Throws as read_problem().
Problem body_problem(const scene::Node& value, const std::filesystem::path& folder,
                     const ProblemWarning& warn);

}  // namespace isostretch::comparison
