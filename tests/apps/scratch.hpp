#pragma once

#include <nlohmann/json.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace isostretch::test {

// A folder of its own for one test, gone afterwards.
class Scratch {
 public:
  Scratch();
  ~Scratch();
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;

  std::string path(const std::string& name) const { return (folder_ / name).string(); }
  std::string write(const std::string& name, const std::string& text) const;

  // Names of all files and folders below, sorted.
  std::vector<std::string> contents() const;

 private:
  std::filesystem::path folder_;
};

// Returns the path of the file.
inline std::string write_scene(const Scratch& scratch, const nlohmann::ordered_json& scene,
                               const std::string& name = "scene.json") {
  return scratch.write(name, scene.dump(2));
}

std::string read_file(const std::string& path);
nlohmann::json read_json(const std::string& path);

}  // namespace isostretch::test
