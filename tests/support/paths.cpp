#include "paths.hpp"

#include <cstdlib>

namespace isostretch::tests {

std::string source_path(const std::string& name) {
  return std::string(ISOSTRETCH_SOURCE_DIR) + "/" + name;
}

std::string outside_path(const std::string& name) {
  const char* folder = std::getenv("ISOSTRETCH_TEST_DATA");
  return (folder != nullptr ? std::string(folder) : source_path("../shared")) + "/" + name;
}

}  // namespace isostretch::tests
