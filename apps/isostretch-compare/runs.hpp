#pragma once

#include "comparison.hpp"
#include "options.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace isostretch::app::compare {

// Runs of this very program with one method on one problem each, every one in a process of its own. A run
// that is there already, made of the same, is not made again.
struct Runs {
  std::filesystem::path scene_file;
  std::filesystem::path out;
  Limits limits;
  int threads = 0;                   // 0: as the program likes
  std::vector<std::string> plugins;  // files

  // `identity`: what the problem is made of.
  Run repetition(const std::string& problem, const std::string& method, int number,
                 const std::string& identity) const;
  // The default method from where that run ended until round-off; no limit of time ends it.
  Run polished(const std::string& problem, const std::string& method, const Run& best,
               const std::string& identity) const;
};

}  // namespace isostretch::app::compare
