#pragma once

#include "problem.hpp"

namespace isostretch::app::compare {

// A body with hard handles, scaled to volume (area in the plane) 1. Throws as read_problem().
Problem body_problem(const scene::Node& value, const std::filesystem::path& folder);

}  // namespace isostretch::app::compare
