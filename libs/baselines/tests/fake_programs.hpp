#pragma once

// Programs of the tests' own that stand in PATH before those of the system.
#include "../src/temporary_folder.hpp"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

namespace isostretch::tests {

class FakePrograms {
 public:
  FakePrograms() : folder_(std::filesystem::path()), path_(std::getenv("PATH")) {
    set_path(folder_.path().string() + ":" + path_);
  }
  ~FakePrograms() { set_path(path_); }
  FakePrograms(const FakePrograms&) = delete;
  FakePrograms& operator=(const FakePrograms&) = delete;

  // A script of the shell.
  void add(const std::string& name, const std::string& script) const {
    const std::filesystem::path file = folder_.path() / name;
    std::ofstream(file) << "#!/bin/sh\n" << script << '\n';
    std::filesystem::permissions(file, std::filesystem::perms::owner_all);
  }

  // Nothing at all is found in PATH, as long as this lives.
  void hide_the_others() const { set_path("/nonexistent"); }

 private:
  static void set_path(const std::string& path) { setenv("PATH", path.c_str(), 1); }

  baselines::TemporaryFolder folder_;
  std::string path_;
};

}  // namespace isostretch::tests
