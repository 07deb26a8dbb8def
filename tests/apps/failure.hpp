#pragma once

#include "process.hpp"
#include "scratch.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <functional>
#include <string>
#include <vector>

namespace isostretch::test {

using App = std::function<Outcome(const std::vector<std::string>& arguments)>;

// The app ends with that code, says why in one line that has these words, and leaves the folder as it was.
inline void check_failure_of(const App& app, const Scratch& scratch,
                             const std::vector<std::string>& arguments, int code,
                             const std::vector<std::string>& words) {
  const auto before = scratch.contents();
  const Outcome run = app(arguments);
  CAPTURE(run.err);
  CHECK(run.code == code);
  CHECK(run.out.empty());
  CHECK(run.err.rfind("error: ", 0) == 0);
  CHECK(std::count(run.err.begin(), run.err.end(), '\n') == 1);
  for (const std::string& word : words) CHECK_MESSAGE(run.err.find(word) != std::string::npos, word);
  CHECK(scratch.contents() == before);
}

}  // namespace isostretch::test
