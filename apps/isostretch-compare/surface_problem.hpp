#pragma once

#include "problem.hpp"

namespace isostretch::app::compare {

// Flattening a disk, from where isostretch-parameterize starts. Throws as read_problem().
Problem surface_problem(const scene::Node& value, const std::filesystem::path& folder);

}  // namespace isostretch::app::compare
