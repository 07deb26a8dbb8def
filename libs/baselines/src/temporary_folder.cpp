#include "temporary_folder.hpp"

#include <isostretch/core/error.hpp>

#include <stdlib.h>

#include <cerrno>
#include <cstring>
#include <string>
#include <system_error>
#include <utility>

namespace isostretch::baselines {

TemporaryFolder::TemporaryFolder(std::filesystem::path parent) {
  if (parent.empty()) parent = std::filesystem::temp_directory_path();
  std::string name = (parent / "isoXXXXXX").string();
  if (!mkdtemp(name.data()))
    throw Error("cannot make a folder in " + parent.string() + ": " + std::strerror(errno));
  path_ = std::move(name);
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

}  // namespace isostretch::baselines
