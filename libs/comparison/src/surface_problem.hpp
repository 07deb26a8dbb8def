#pragma once

#include <isostretch/comparison/problem.hpp>

namespace isostretch::comparison {

// Flattening a disk, from where isostretch-parameterize starts. Throws as read_problem().
Problem surface_problem(const scene::Node& value, const std::filesystem::path& folder);

}  // namespace isostretch::comparison
