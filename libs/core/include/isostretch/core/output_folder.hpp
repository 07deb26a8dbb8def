#pragma once

#include <isostretch/core/atomic_file.hpp>

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace isostretch {

/// A folder for results, made when it is not there. Files added appear in it all together at commit() or not
/// at all, and without commit() folders that were made are taken away again, unless something was written at
/// once. Everything throws Error of the kind `resource`, naming the file or folder.
class OutputFolder {
 public:
  /// Makes the folder. Fails at once, before hours of work, when files cannot be made there.
  explicit OutputFolder(std::filesystem::path folder);
  /// Takes away what was not committed.
  ~OutputFolder();
  OutputFolder(const OutputFolder&) = delete;
  OutputFolder& operator=(const OutputFolder&) = delete;

  /// Adds a file, which appears at commit().
  void add(const std::string& name, std::string_view content);
  /// Writes this file alone, and at once; the folder stays from then on.
  void write_now(const std::string& name, std::string_view content);
  /// Lets all added files appear.
  void commit();

  /// Returns the files added or written, in order, each once.
  const std::vector<std::filesystem::path>& paths() const { return paths_; }

 private:
  void make_folder();
  void take_folders_away() noexcept;

  std::filesystem::path folder_;
  std::vector<std::filesystem::path> made_;  // outermost first
  std::vector<std::filesystem::path> paths_;
  std::vector<std::unique_ptr<AtomicFile>> files_;
  bool committed_ = false;
};

}  // namespace isostretch
