#include <isostretch/core/error.hpp>
#include <isostretch/mesh/io.hpp>

#include <filesystem>

namespace isostretch::mesh {

SurfaceMesh read_surface(const std::string& path, const ReadOptions& options) {
  std::string extension = std::filesystem::path(path).extension().string();
  for (char& c : extension)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  if (extension == ".obj") return read_obj(path, options);
  if (extension == ".off") return read_off(path, options);
  throw Error(path + ": cannot tell the format: the name ends neither in .obj nor in .off");
}

}  // namespace isostretch::mesh
