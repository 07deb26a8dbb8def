// The one source into which paths of the build are compiled, so that a compiler cache serves every build
// folder.
#include "programs.hpp"

#include <map>

namespace isostretch::test {

std::string program(const std::string& name) {
  static const std::map<std::string, std::string> paths{
      {"compare", ISOSTRETCH_COMPARE},       {"deform", ISOSTRETCH_DEFORM},
      {"energy", ISOSTRETCH_ENERGY},         {"interpolate", ISOSTRETCH_INTERPOLATE},
      {"manipulate", ISOSTRETCH_MANIPULATE}, {"parameterize", ISOSTRETCH_PARAMETERIZE}};
  return paths.at(name);
}

std::string test_plugin() {
  return ISOSTRETCH_TEST_PLUGIN;
}

}  // namespace isostretch::test
