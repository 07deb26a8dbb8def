#pragma once

#include "common/output_folder.hpp"

#include <string>
#include <vector>

namespace isostretch::app::parameterize {

// What a reader of the result should know before using it, from summary.json.
std::vector<std::string> report_warnings(const Json& summary);

}  // namespace isostretch::app::parameterize
