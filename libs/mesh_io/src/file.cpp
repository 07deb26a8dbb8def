#include "file.hpp"

#include <isostretch/core/atomic_file.hpp>
#include <isostretch/core/error.hpp>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>

namespace isostretch::mesh {
namespace {

// What to expect, or 0 for a pipe and the like.
std::size_t size_of_file(const std::string& path) {
  std::error_code unknown;
  const std::uintmax_t size = std::filesystem::file_size(path, unknown);
  return unknown ? 0 : static_cast<std::size_t>(size);
}

}  // namespace

std::string read_file(const std::string& path) {
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"), &std::fclose);
  if (!file) throw Error(path + ": cannot read: " + std::strerror(errno));
  std::string contents;
  constexpr std::size_t chunk = std::size_t{1} << 16;
  std::size_t more = size_of_file(path) + 1;  // one more shows the end without growing
  for (std::size_t size = 0;; more = std::max(chunk, size / 2)) {
    contents.resize(size + more);
    const std::size_t got = std::fread(contents.data() + size, 1, more, file.get());
    size += got;
    if (got == more) continue;
    if (std::ferror(file.get())) throw Error(path + ": cannot read: " + std::strerror(errno));
    contents.resize(size);
    return contents;
  }
}

void write_file(const std::string& path, std::string_view contents) {
  AtomicFile file(path);
  file.write(contents);
  file.commit();
}

}  // namespace isostretch::mesh
