#include "xml.hpp"

#include "characters.hpp"
#include "number.hpp"

namespace isostretch::mesh {
namespace {

bool ends_name(char c) {
  return is_space(c) || c == '>' || c == '/' || c == '=' || c == '<' || c == '"' || c == '\'';
}

}  // namespace

std::string_view XmlTag::attribute(std::string_view wanted) const {
  for (const auto& [key, value] : attributes)
    if (key == wanted) return value;
  return {};
}

bool XmlScanner::starts_with(std::string_view text) const {
  return contents_.substr(position_, text.size()) == text;
}

void XmlScanner::skip_past(std::string_view end, const char* what) {
  const std::size_t found = contents_.find(end, position_);
  if (found == std::string_view::npos) fail(std::string(what) + " does not end");
  position_ = found + end.size();
}

void XmlScanner::skip_space() {
  while (position_ < contents_.size() && is_space(contents_[position_])) ++position_;
}

std::string_view XmlScanner::take_name() {
  const std::size_t start = position_;
  while (position_ < contents_.size() && !ends_name(contents_[position_])) ++position_;
  if (position_ == start) fail("name expected in a tag");
  return contents_.substr(start, position_ - start);
}

bool XmlScanner::next(XmlTag& tag) {
  for (;;) {
    position_ = std::min(contents_.find('<', position_), contents_.size());
    if (position_ == contents_.size()) break;
    if (starts_with("<!--"))
      skip_past("-->", "comment");
    else if (starts_with("<?"))
      skip_past("?>", "processing instruction");
    else if (starts_with("<!"))
      fail("document types and CDATA sections are not understood");
    else {
      read_rest(tag);
      match(tag);
      return true;
    }
  }
  if (!open_.empty()) fail("the file ends within the element " + quoted(open_.back()));
  return false;
}

void XmlScanner::read_rest(XmlTag& tag) {
  tag = {};
  tag.start = position_++;
  if (starts_with("/")) {
    tag.kind = XmlTag::Kind::close;
    ++position_;
  }
  tag.name = take_name();
  for (skip_space(); !starts_with(">") && !starts_with("/>"); skip_space()) read_attribute(tag);
  if (starts_with("/")) {
    if (tag.kind == XmlTag::Kind::close) fail("tag of unknown form");
    tag.kind = XmlTag::Kind::empty;
    ++position_;
  }
  tag.end = ++position_;
}

void XmlScanner::read_attribute(XmlTag& tag) {
  if (position_ == contents_.size()) fail("the file ends within a tag");
  if (tag.kind == XmlTag::Kind::close) fail("attribute in a closing tag");
  const std::string_view name = take_name();
  skip_space();
  if (!starts_with("=")) fail("attribute " + quoted(name) + " without a value");
  ++position_;
  skip_space();
  if (!starts_with("\"") && !starts_with("'"))
    fail("value of attribute " + quoted(name) + " is not in quotes");
  const char quote = contents_[position_++];
  const std::size_t start = position_;
  skip_past(std::string_view(&quote, 1), "value of an attribute");
  tag.attributes.emplace_back(name, contents_.substr(start, position_ - 1 - start));
}

void XmlScanner::match(const XmlTag& tag) {
  if (tag.kind == XmlTag::Kind::open) open_.push_back(tag.name);
  if (tag.kind != XmlTag::Kind::close) return;
  if (open_.empty() || open_.back() != tag.name)
    place(tag.start).fail("closing tag " + quoted(tag.name) + " does not match");
  open_.pop_back();
}

}  // namespace isostretch::mesh
