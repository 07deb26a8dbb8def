// What holds for the command line of every app.
#include "process.hpp"

#include <doctest/doctest.h>

#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

using namespace isostretch::test;

namespace {

const std::vector<std::string> apps = {program("compare"),    program("deform"),
                                       program("energy"),     program("interpolate"),
                                       program("manipulate"), program("parameterize")};

std::string help_of(const std::string& app) {
  const Outcome outcome = run({app, "--help"});
  CHECK(outcome.code == 0);
  return outcome.out;
}

struct Flag {
  std::string name, type;
};

// Options that take something, as --help lists them.
std::vector<Flag> flags_of(const std::string& app) {
  std::vector<Flag> flags;
  std::istringstream lines(help_of(app));
  const std::regex pattern("^  (?:-[a-z],)?(--[a-z-]+) ([A-Z][^ ]*).*");
  std::smatch match;
  for (std::string line; std::getline(lines, line);)
    if (std::regex_match(line, match, pattern)) flags.push_back({match[1], match[2]});
  return flags;
}

}  // namespace

TEST_SUITE("command lines") {
  TEST_CASE("--help is grouped, fits into 80 columns and ends with an example") {
    for (const std::string& app : apps) {
      CAPTURE(app);
      const std::string help = help_of(app);
      std::istringstream lines(help);
      int groups = 0;
      for (std::string line; std::getline(lines, line);) {
        CHECK_MESSAGE(line.size() <= 80, line);
        groups += !line.empty() && line.front() != ' ' && line.back() == ':';
      }
      CHECK(groups >= 5);
      CHECK(help.find("\n\n\n") == std::string::npos);
      CHECK(help.find('{') == std::string::npos);
      CHECK(help.find("Example:\n  isostretch-") != std::string::npos);
    }
  }

  TEST_CASE("NaN, infinity, what is beyond double and what is no number is refused by every numeric option") {
    const std::set<std::string> numeric = {"N", "X", "K", "E", "NU", "MB", "SECONDS"};
    const std::set<std::string> lists = {"LOW:HIGH",     "N|FIRST:LAST",        "A,B,C,D",    "A,B[,C...]",
                                         "VERTEX[:U,V]", "VERTEX:U,V[:WEIGHT]", "NAME=VALUE", "HANDLE"};
    int refused = 0;
    for (const std::string& app : apps)
      for (const auto& one : flags_of(app)) {
        const auto& [flag, type] = one;
        std::vector<std::string> values;
        if (numeric.count(type))
          values = {"nan", "-nan", "NaN", "inf", "-inf", "1e400", "1x", ""};
        else if (lists.count(type))
          values = {"nan",       "nan:nan", "nan,nan,nan,nan",  "0:nan,0",
                    "0:0,0:nan", "mu=nan",  "sphere:0,0,0,nan", "inf"};
        for (const std::string& value : values) {
          CAPTURE(app);
          CAPTURE(one.name);
          CAPTURE(value);
          const Outcome outcome = run({app, "no_such_file.msh", flag + "=" + value, "--out", "never_made"});
          // Interpolation wants a second file; what is read first is refused first.
          CHECK(outcome.code == 2);
          if (numeric.count(type)) CHECK_MESSAGE(outcome.err.find(flag) != std::string::npos, outcome.err);
          ++refused;
        }
      }
    CHECK(refused > 300);
  }

  TEST_CASE("--log-level and --log-file say how a solver goes about it") {
    const Outcome outcome = run({program("energy"), "arap", "--log-level", "loud"});
    CHECK(outcome.code == 2);
    CHECK(outcome.err.find("'loud' is none of trace, debug, info, warning, error") != std::string::npos);
    const Outcome unwritable = run({program("energy"), "arap", "--log-file", "/dev/null/log.txt"});
    CHECK(unwritable.code == 4);
    CHECK(unwritable.err.find("/dev/null/log.txt: cannot be written") != std::string::npos);
  }
}
