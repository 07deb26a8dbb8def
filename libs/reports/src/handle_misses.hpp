#pragma once

#include "json.hpp"

#include <isostretch/deformation/handle_misses.hpp>

#include <string>
#include <vector>

namespace isostretch::reports {

Json json_of(const std::vector<deformation::HandleMiss>& misses);

// Rows for a page: `handles` as summaries describe them, with what json_of() says of their misses.
std::string handle_table(const Json& handles, const Json& misses);

}  // namespace isostretch::reports
