#pragma once

#include "paths.hpp"

#include <doctest/doctest.h>

#include <initializer_list>
#include <string>
#include <utility>

// Test cases that cannot run everywhere. Each is an entry of its own in CTest, which says "Skipped" where it
// did not run: a program one of whose cases was skipped, and none failed, ends with `skip_code`.
namespace isostretch::tests {

inline constexpr int skip_code = 77;                       // SKIP_RETURN_CODE of IsostretchTests.cmake
inline constexpr const char* conditional = "conditional";  // the suite of these cases, whatever else it was

/// Decorates a case that runs where `obstacle` is empty, and otherwise is skipped with that as the reason.
class RunsUnless {
 public:
  explicit RunsUnless(std::string obstacle) : obstacle_(std::move(obstacle)) {}

  /// Called by doctest.
  void fill(doctest::detail::TestCase& test) const;

 private:
  std::string obstacle_;
};

/// Returns the decorator of a case that reads these files or folders of the outside data, all of them, by
/// outside_path(): `TEST_CASE("..." * outside_data({"meshes/disks/face_52k.obj"}))`.
RunsUnless outside_data(std::initializer_list<const char*> names);

/// Returns the decorator of a case that takes minutes under a sanitizer, which others show as much to.
RunsUnless slow_under_sanitizers();

/// Returns how many cases were skipped so far.
int skipped_cases();

}  // namespace isostretch::tests
