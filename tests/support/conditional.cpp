#include "conditional.hpp"

#include <filesystem>
#include <map>

namespace isostretch::tests {
namespace {

// Why cases do not run, by file and line. Decorators work before main() does.
std::map<std::pair<std::string, unsigned>, std::string>& obstacles() {
  static std::map<std::pair<std::string, unsigned>, std::string> map;
  return map;
}

int skipped = 0;

std::pair<std::string, unsigned> place_of(const doctest::detail::TestCase& test) {
  return {test.m_file.c_str(), test.m_line};
}

// Takes the place of a case.
void skip() {
  ++skipped;
  MESSAGE("skipped: " << obstacles().at(place_of(*doctest::getContextOptions()->currentTest)));
}

}  // namespace

void RunsUnless::fill(doctest::detail::TestCase& test) const {
  test.m_test_suite = conditional;
  if (obstacle_.empty()) return;
  std::string& obstacle = obstacles()[place_of(test)];
  obstacle += (obstacle.empty() ? "" : ", ") + obstacle_;
  test.m_test = &skip;
}

RunsUnless outside_data(std::initializer_list<const char*> names) {
  std::string missing;
  for (const char* name : names)
    if (!std::filesystem::exists(outside_path(name)))
      missing += (missing.empty() ? "" : ", ") + outside_path(name) + " is not there";
  return RunsUnless(missing);
}

RunsUnless slow_under_sanitizers() {
#ifdef ISOSTRETCH_SANITIZED
  return RunsUnless("it takes minutes under a sanitizer");
#else
  return RunsUnless("");
#endif
}

int skipped_cases() {
  return skipped;
}

}  // namespace isostretch::tests
