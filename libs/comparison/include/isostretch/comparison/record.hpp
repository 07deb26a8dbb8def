#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <utility>

namespace isostretch::comparison {

/// A JSON document that a run or a program wrote of itself, kept as it is: the order of keys, and whole
/// numbers as such. Copies share it.
class Record {
 public:
  /// The document itself, which only the library sees.
  struct Content;

  /// Makes a record of nothing, null.
  Record() = default;
  /// Makes a record of that document.
  explicit Record(std::shared_ptr<const Content> content) : content_(std::move(content)) {}

  /// Returns the record of a JSON text; null where it is none, for it may have been cut off.
  static Record parse(const std::string& text);
  /// Returns the record in a file; null where there is none.
  static Record of_file(const std::filesystem::path& file);

  /// Returns whether it is an object.
  bool is_object() const;
  /// Returns the number of that key; NaN where it has none.
  double number(const char* key) const;
  /// Returns the text of that key; empty where it has none.
  std::string text(const char* key) const;
  /// Returns whether the value of that key is true.
  bool truth(const char* key) const;
  /// Returns the value of that key; null where it has none.
  Record at(const char* key) const;

  /// Returns it as JSON, in one line with a negative indent. What is not UTF-8 is replaced.
  std::string to_json(int indent = -1) const;

  /// Returns the document; none where it is null.
  const Content* content() const { return content_.get(); }

 private:
  std::shared_ptr<const Content> content_;
};

}  // namespace isostretch::comparison
