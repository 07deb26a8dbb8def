#pragma once

#include "common/deformation_names.hpp"

#include "common/output_folder.hpp"

#include <string>
#include <vector>

namespace isostretch::app {

Json misses_json(const std::vector<deformation::HandleMiss>& misses);

/// Rows for a report: `handles` as summaries describe them, with what misses_json() says of them.
std::string handle_table(const Json& handles, const Json& misses);

}  // namespace isostretch::app
