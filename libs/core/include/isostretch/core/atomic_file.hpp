#pragma once

#include <cstdio>
#include <string>
#include <string_view>

namespace isostretch {

// A file that appears under its name complete or not at all: written beside it under a temporary name, then
// renamed. Destroyed without commit() it leaves nothing behind. Every failure (open, full disk, rename)
// throws Error with the path and the system's reason.
class AtomicFile {
 public:
  explicit AtomicFile(std::string path);
  ~AtomicFile();
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  void write(std::string_view text);
  void commit();

  // Where the text is until commit(): for libraries that insist on opening a file by name.
  const std::string& temporary_path() const noexcept { return temporary_path_; }

 private:
  [[noreturn]] void fail(const char* action);

  std::string path_;
  std::string temporary_path_;
  std::FILE* file_ = nullptr;
};

}  // namespace isostretch
