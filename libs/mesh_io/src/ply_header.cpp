#include "ply_header.hpp"

#include "number.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

namespace isostretch::mesh {
namespace {

Scalar type_of(const InputCursor& cursor, std::string_view name) {
  constexpr std::array<std::pair<std::string_view, Scalar>, 16> types = {{
      {"char", Scalar::int8},
      {"int8", Scalar::int8},
      {"uchar", Scalar::uint8},
      {"uint8", Scalar::uint8},
      {"short", Scalar::int16},
      {"int16", Scalar::int16},
      {"ushort", Scalar::uint16},
      {"uint16", Scalar::uint16},
      {"int", Scalar::int32},
      {"int32", Scalar::int32},
      {"uint", Scalar::uint32},
      {"uint32", Scalar::uint32},
      {"float", Scalar::float32},
      {"float32", Scalar::float32},
      {"double", Scalar::float64},
      {"float64", Scalar::float64},
  }};
  for (const auto& [known, type] : types)
    if (known == name) return type;
  cursor.fail("property of unknown type " + quoted(name));
}

Coding coding_of(InputCursor& cursor) {
  const std::string_view name = cursor.word();
  for (const auto& [known, coding] : {std::pair{"ascii", Coding::text},
                                      {"binary_little_endian", Coding::little_endian},
                                      {"binary_big_endian", Coding::big_endian}})
    if (name == known) return coding;
  cursor.fail("unknown format " + quoted(name));
}

PlyElement element(InputCursor& cursor) {
  PlyElement element;
  element.name = cursor.word();
  element.count = cursor.text_integer("number of elements");
  element.place = cursor.place().position;
  return element;
}

PlyProperty property(InputCursor& cursor) {
  PlyProperty property;
  std::string_view type = cursor.word();
  property.list = type == "list";
  if (property.list) {
    property.count_type = type_of(cursor, cursor.word());
    if (is_real(property.count_type)) cursor.fail("the length of a list is not of an integer type");
    type = cursor.word();
  }
  property.type = type_of(cursor, type);
  property.name = cursor.word();
  if (property.name.empty()) cursor.fail("property without a name");
  return property;
}

}  // namespace

std::size_t PlyElement::find(std::string_view property) const {
  const auto found = std::find_if(properties.begin(), properties.end(),
                                  [&](const PlyProperty& p) { return p.name == property; });
  return static_cast<std::size_t>(found - properties.begin());
}

std::vector<PlyElement> read_ply_header(InputCursor& cursor) {
  cursor.set_by_line(true);
  if (cursor.word() != "ply") cursor.fail("not a PLY file: it does not begin with ply");
  std::vector<PlyElement> elements;
  std::optional<Coding> coding;
  for (;;) {
    cursor.next_line();
    const std::string_view keyword = cursor.word();
    if (keyword == "end_header") break;
    if (keyword == "format") {
      coding = coding_of(cursor);
    } else if (keyword == "element") {
      elements.push_back(element(cursor));
    } else if (keyword == "property") {
      if (elements.empty()) cursor.fail("property before the first element");
      elements.back().properties.push_back(property(cursor));
    } else if (keyword.empty()) {
      cursor.fail("the file ends within its header");
    } else if (keyword != "comment" && keyword != "obj_info") {
      cursor.fail("unknown statement " + quoted(keyword) + " in the header");
    }
  }
  if (!coding) cursor.fail("the header does not state a format");
  cursor.line();  // binary data begin right after it
  cursor.set_coding(*coding);
  return elements;
}

}  // namespace isostretch::mesh
