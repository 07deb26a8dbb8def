#pragma once

#include <isostretch/inspection/findings.hpp>

#include <string>
#include <vector>

namespace isostretch::reports {

/// Returns what was found out about an energy, as tables for a terminal.
std::string report_text(const inspection::Findings& findings);

/// Returns the summary as a JSON text, indented and with a line break at the end.
std::string summary_text(const inspection::Findings& findings);

/// Returns a page of HTML that needs nothing else. `maps` are the bytes of a PNG for every study, see
/// figures::EnergyMaps.
std::string report_page(const inspection::Findings& findings, const std::vector<std::string>& maps);

}  // namespace isostretch::reports
