#include <isostretch/core/atomic_file.hpp>
#include <isostretch/core/error.hpp>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <utility>

#include <unistd.h>

namespace isostretch {

AtomicFile::AtomicFile(std::string path)
    : path_(std::move(path)), temporary_path_(path_ + ".part" + std::to_string(::getpid())) {
  if (path_.empty()) throw Error(ErrorKind::misuse, "cannot write a file without a name");
  if (std::error_code ignored; std::filesystem::is_directory(path_, ignored))
    throw Error(ErrorKind::resource, path_ + ": cannot write: is a directory");
  file_ = std::fopen(temporary_path_.c_str(), "wb");
  if (file_ == nullptr) throw Error(ErrorKind::resource, path_ + ": cannot write: " + std::strerror(errno));
}

AtomicFile::~AtomicFile() {
  if (file_ == nullptr) return;
  std::fclose(file_);
  std::remove(temporary_path_.c_str());
}

void AtomicFile::write(std::string_view text) {
  if (std::fwrite(text.data(), 1, text.size(), file_) != text.size()) fail("cannot write");
}

void AtomicFile::commit() {
  if (std::fflush(file_) != 0 || ::fsync(::fileno(file_)) != 0) fail("cannot write");
  std::FILE* closing = std::exchange(file_, nullptr);
  if (std::fclose(closing) != 0 || std::rename(temporary_path_.c_str(), path_.c_str()) != 0) {
    const std::string reason = std::strerror(errno);
    std::remove(temporary_path_.c_str());
    throw Error(ErrorKind::resource, path_ + ": cannot write: " + reason);
  }
}

void AtomicFile::fail(const char* action) {
  throw Error(ErrorKind::resource, path_ + ": " + action + ": " + std::strerror(errno));
}

}  // namespace isostretch
