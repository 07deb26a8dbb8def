#pragma once

#include <isostretch/core/atomic_file.hpp>

#include <nlohmann/json_fwd.hpp>

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace isostretch::app {

using Json = nlohmann::ordered_json;

// The folder an app writes to, made when it is not there. Files added appear in it all together at commit()
// or not at all, and without commit() folders that were made are taken away again, unless something was
// written at once. Everything throws Error.
class OutputFolder {
 public:
  // Fails at once, before hours of work, when files cannot be made there.
  explicit OutputFolder(std::filesystem::path folder);
  ~OutputFolder();
  OutputFolder(const OutputFolder&) = delete;
  OutputFolder& operator=(const OutputFolder&) = delete;

  void add(const std::string& name, std::string_view content);
  void add_json(const std::string& name, const Json& json);
  // This file alone, and at once; the folder stays from then on.
  void write_now(const std::string& name, std::string_view content);
  void commit();

  // Of the files added or written, in order, each once.
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

}  // namespace isostretch::app
