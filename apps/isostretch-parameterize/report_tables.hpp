#pragma once

#include "common/output_folder.hpp"

#include <string>

namespace isostretch::app::parameterize {

// Parts of report.html, each from summary.json.
std::string facts(const Json& summary);
std::string chart_table(const Json& charts);
std::string option_table(const Json& summary);

}  // namespace isostretch::app::parameterize
