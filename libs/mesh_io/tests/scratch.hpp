#pragma once

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

namespace isostretch::mesh::test {

// A folder for the files of one test, removed with it.
class Scratch {
 public:
  Scratch()
      : path_(std::filesystem::temp_directory_path() / ("isostretch_mesh_io_" + std::to_string(::getpid()))) {
    std::filesystem::remove_all(path_);
    std::filesystem::create_directories(path_);
  }
  ~Scratch() { std::filesystem::remove_all(path_); }
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;

  std::string file(const std::string& name) const { return (path_ / name).string(); }
  std::string with(const std::string& name, const std::string& contents) const {
    std::ofstream(file(name), std::ios::binary) << contents;
    return file(name);
  }
  bool empty() const { return std::filesystem::is_empty(path_); }

 private:
  std::filesystem::path path_;
};

}  // namespace isostretch::mesh::test
