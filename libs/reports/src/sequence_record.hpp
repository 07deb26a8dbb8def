#pragma once

#include "frames.hpp"

#include <isostretch/reports/sequence_report.hpp>

namespace isostretch::reports {

struct SequenceReport::Record {
  SequenceInput input;
  SequenceEnd end = SequenceEnd::finished;
  std::string message = {};  // of the frame that ended it, when not finished
  Json frames = Json::array();
  std::string trace = {};
  int restarted_at = 0;  // first frame made in this run
  std::vector<std::string> warnings = {};

  Json summary(const std::string& verdict, const RunFacts& facts) const;
};

}  // namespace isostretch::reports
