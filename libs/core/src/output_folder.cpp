#include <isostretch/core/error.hpp>
#include <isostretch/core/output_folder.hpp>

#include <algorithm>
#include <utility>

namespace isostretch {
namespace fs = std::filesystem;

OutputFolder::OutputFolder(fs::path folder) : folder_(std::move(folder)) {
  try {
    with_error_kind(ErrorKind::resource, [this] {
      make_folder();
      const AtomicFile probe((folder_ / "writable").string());  // never committed
    });
  } catch (...) {
    take_folders_away();
    throw;
  }
}

OutputFolder::~OutputFolder() {
  files_.clear();
  if (!committed_) take_folders_away();
}

void OutputFolder::make_folder() {
  if (!folder_.has_filename()) folder_ = folder_.parent_path();  // "out/" is "out"
  if (folder_.empty()) folder_ = "/";
  for (fs::path p = folder_; !p.empty() && !fs::exists(p); p = p.parent_path()) made_.push_back(p);
  std::reverse(made_.begin(), made_.end());
  if (fs::exists(folder_) && !fs::is_directory(folder_))
    throw Error(ErrorKind::resource, folder_.string() + ": cannot write there: is not a folder");
  std::error_code error;
  fs::create_directories(folder_, error);
  if (error)
    throw Error(ErrorKind::resource, folder_.string() + ": cannot make the folder: " + error.message());
}

void OutputFolder::take_folders_away() noexcept {
  std::error_code ignored;
  // remove() leaves a folder alone that somebody else has put something into.
  for (auto p = made_.rbegin(); p != made_.rend(); ++p) fs::remove(*p, ignored);
}

void OutputFolder::add(const std::string& name, std::string_view content) {
  with_error_kind(ErrorKind::resource, [&] {
    auto file = std::make_unique<AtomicFile>((folder_ / name).string());
    file->write(content);
    files_.push_back(std::move(file));
    paths_.push_back(folder_ / name);
  });
}

void OutputFolder::write_now(const std::string& name, std::string_view content) {
  with_error_kind(ErrorKind::resource, [&] {
    AtomicFile file((folder_ / name).string());
    file.write(content);
    file.commit();
    committed_ = true;
    if (std::find(paths_.begin(), paths_.end(), folder_ / name) == paths_.end())
      paths_.push_back(folder_ / name);
  });
}

void OutputFolder::commit() {
  with_error_kind(ErrorKind::resource, [this] {
    for (auto& file : files_) file->commit();
  });
  committed_ = true;
}

}  // namespace isostretch
