// The summary of a parameterization, and parts of the page, each from the summary.
#pragma once

#include "json.hpp"

#include <isostretch/reports/parameterization_report.hpp>

#include <string>
#include <vector>

namespace isostretch::reports {

Json summary_json(const ParameterizationReport& report, const RunFacts& facts);

std::string fact_tables(const Json& summary);
std::string chart_table(const Json& charts);
std::string option_table(const Json& summary);

// What a reader of the result should know before using it.
std::vector<std::string> page_warnings(const Json& summary);

}  // namespace isostretch::reports
