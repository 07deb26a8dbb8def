#pragma once

#include "place.hpp"

#include <string_view>
#include <utility>
#include <vector>

namespace isostretch::mesh {

struct XmlTag {
  enum class Kind { open, close, empty };
  Kind kind = Kind::open;
  std::string_view name;
  std::size_t start = 0;  // of its '<'
  std::size_t end = 0;    // behind its '>'
  std::vector<std::pair<std::string_view, std::string_view>> attributes;

  // Value as it stands in the file, or empty.
  std::string_view attribute(std::string_view wanted) const;
};

// Tags of an XML file one after the other; comments and processing instructions are passed over, and so is
// text. No document types, no CDATA: what the files of VTK have no use for is an error, and so are tags that
// do not match. Entities are left as they are.
class XmlScanner {
 public:
  XmlScanner(std::string_view contents, const std::string& name) : contents_(contents), name_(name) {}

  // false: the end of the file, with all tags closed.
  bool next(XmlTag& tag);
  // Names of the tags that are open, outermost first; a tag that next() opened is among them.
  const std::vector<std::string_view>& open() const { return open_; }

  Place place(std::size_t position) const { return {contents_, name_, position, false}; }

 private:
  bool starts_with(std::string_view text) const;
  void skip_past(std::string_view end, const char* what);
  void skip_space();
  std::string_view take_name();
  void read_attribute(XmlTag& tag);
  void read_rest(XmlTag& tag);
  void match(const XmlTag& tag);
  [[noreturn]] void fail(const std::string& what) const { place(position_).fail(what); }

  std::string_view contents_;
  const std::string& name_;
  std::size_t position_ = 0;
  std::vector<std::string_view> open_;
};

}  // namespace isostretch::mesh
