#pragma once

#include "frames.hpp"

#include <isostretch/reports/interpolation_report.hpp>

namespace isostretch::reports {

struct InterpolationReport::Record {
  InterpolationInput input;
  InterpolationEnd end = InterpolationEnd::finished;
  std::string message = {};  // of the frame that ended it, when not finished
  Json frames = Json::array();
  std::string trace = {};
  newton::Seconds phases = {};
  std::string solver = {};  // of the linear systems
  std::vector<figures::Snapshot> snapshots = {};
  std::vector<std::string> warnings = {};

  Json summary(const std::string& verdict, const RunFacts& facts) const;
};

}  // namespace isostretch::reports
