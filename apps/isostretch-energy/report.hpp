#pragma once

#include "common/output_folder.hpp"
#include "wording.hpp"

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace isostretch::app::inspect {

// For the terminal.
std::string report_text(const Findings& findings);

Json summary_json(const Findings& findings);

// report.html. `maps`: the PNG of every study.
std::string report_page(const Findings& findings, const std::vector<std::string>& maps);

}  // namespace isostretch::app::inspect
