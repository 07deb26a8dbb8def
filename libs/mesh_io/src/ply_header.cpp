#include "ply_header.hpp"

#include "number.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

namespace isostretch::mesh {
namespace {

Scalar type_of(const Source& source, std::string_view name) {
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
  source.fail("property of unknown type " + quoted(name));
}

Coding coding_of(Source& source) {
  const std::string_view name = source.word();
  for (const auto& [known, coding] : {std::pair{"ascii", Coding::text},
                                      {"binary_little_endian", Coding::little_endian},
                                      {"binary_big_endian", Coding::big_endian}})
    if (name == known) return coding;
  source.fail("unknown format " + quoted(name));
}

PlyElement element(Source& source) {
  PlyElement element;
  element.name = source.word();
  element.count = source.text_integer("number of elements");
  element.place = source.place().position;
  return element;
}

PlyProperty property(Source& source) {
  PlyProperty property;
  std::string_view type = source.word();
  property.list = type == "list";
  if (property.list) {
    property.count_type = type_of(source, source.word());
    if (is_real(property.count_type)) source.fail("the length of a list is not of an integer type");
    type = source.word();
  }
  property.type = type_of(source, type);
  property.name = source.word();
  if (property.name.empty()) source.fail("property without a name");
  return property;
}

}  // namespace

std::size_t PlyElement::find(std::string_view property) const {
  const auto found = std::find_if(properties.begin(), properties.end(),
                                  [&](const PlyProperty& p) { return p.name == property; });
  return static_cast<std::size_t>(found - properties.begin());
}

std::vector<PlyElement> read_ply_header(Source& source) {
  source.set_by_line(true);
  if (source.word() != "ply") source.fail("not a PLY file: it does not begin with ply");
  std::vector<PlyElement> elements;
  std::optional<Coding> coding;
  for (;;) {
    source.next_line();
    const std::string_view keyword = source.word();
    if (keyword == "end_header") break;
    if (keyword == "format") {
      coding = coding_of(source);
    } else if (keyword == "element") {
      elements.push_back(element(source));
    } else if (keyword == "property") {
      if (elements.empty()) source.fail("property before the first element");
      elements.back().properties.push_back(property(source));
    } else if (keyword.empty()) {
      source.fail("the file ends within its header");
    } else if (keyword != "comment" && keyword != "obj_info") {
      source.fail("unknown statement " + quoted(keyword) + " in the header");
    }
  }
  if (!coding) source.fail("the header does not state a format");
  source.line();  // binary data begin right after it
  source.set_coding(*coding);
  return elements;
}

}  // namespace isostretch::mesh
