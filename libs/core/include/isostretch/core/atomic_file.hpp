#pragma once

#include <cstdio>
#include <string>
#include <string_view>

namespace isostretch {

/// A file that appears under its name complete or not at all: it is written beside it under a temporary name,
/// then renamed. An AtomicFile destroyed without commit() leaves nothing behind. Every failure (open, full
/// disk, rename) throws Error with the path and the reason that the system gives.
class AtomicFile {
 public:
  /// Opens the temporary file beside `path`. Throws Error if that is not possible.
  explicit AtomicFile(std::string path);
  ~AtomicFile();
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  /// Appends bytes. Throws Error if they cannot be written.
  void write(std::string_view text);
  /// Closes the file and gives it its name, in place of a file that has it already. Throws Error if the disk
  /// is full or renaming fails.
  void commit();

  /// Returns the path of the temporary file that holds the text until commit(), for libraries that open a
  /// file by its name.
  const std::string& temporary_path() const noexcept { return temporary_path_; }

 private:
  [[noreturn]] void fail(const char* action);

  std::string path_;
  std::string temporary_path_;
  std::FILE* file_ = nullptr;
};

}  // namespace isostretch
