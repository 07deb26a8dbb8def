#pragma once

#include <string>

namespace isostretch::test {

/// Returns the path of an app of this build, by its name without "isostretch-".
std::string program(const std::string& name);

/// Returns the path of the plug-in that is compiled for the tests.
std::string test_plugin();

}  // namespace isostretch::test
