#pragma once

#include <filesystem>

namespace isostretch::baselines {

// A folder of its own that is gone, with all that is in it, when this object is. Its name is short: programs
// have buffers for names.
class TemporaryFolder {
 public:
  // Inside `parent`; empty: the system's folder for such. Throws Error naming the folder and the system's
  // reason.
  explicit TemporaryFolder(std::filesystem::path parent);
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace isostretch::baselines
