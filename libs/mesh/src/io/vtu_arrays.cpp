#include "vtu_arrays.hpp"

#include "base64.hpp"
#include "number.hpp"
#include "source.hpp"

#include <array>
#include <charconv>
#include <cmath>

namespace isostretch::mesh {

VtuArray describe_array(const XmlTag& tag) {
  return {true,
          tag.start,
          tag.attribute("type"),
          tag.attribute("format"),
          tag.attribute("offset"),
          tag.attribute("NumberOfComponents"),
          tag.end};
}

Scalar VtuArrays::type_of(const VtuArray& array) const {
  constexpr std::array<std::string_view, 10> names = {"Int8",   "UInt8", "Int16",  "UInt16",  "Int32",
                                                      "UInt32", "Int64", "UInt64", "Float32", "Float64"};
  for (std::size_t i = 0; i < names.size(); ++i)
    if (names[i] == array.type) return static_cast<Scalar>(i);
  place(array.start).fail("DataArray of unknown type " + quoted(array.type));
}

// Up to the next tag. Nothing for a tag that closes itself.
std::string_view VtuArrays::text_of(const VtuArray& array) const {
  if (contents_[array.text - 2] == '/') return {};
  return contents_.substr(array.text, contents_.find('<', array.text) - array.text);
}

void VtuArrays::require_readable(const VtuArray& array) const {
  if (coding_.compressed)
    place(array.start).fail("compressed data are not read: write the file without compression");
  if (!coding_.has_byte_order) place(array.start).fail("binary data in a file without byte_order");
}

void VtuArrays::take_header(Bytes& bytes, bool exact) const {
  const std::size_t size = size_of(coding_.header);
  if (bytes.bytes.size() < size) bytes.place.fail("the data end within their header");
  const auto length = static_cast<std::uint64_t>(load_integer(bytes.bytes.data(), coding_.header, swap()));
  bytes.bytes.remove_prefix(size);
  if (length > bytes.bytes.size() || (exact && length < bytes.bytes.size()))
    bytes.place.fail("array of " + std::to_string(length) + " bytes, where " +
                     std::to_string(bytes.bytes.size()) + " are left");
  bytes.bytes = bytes.bytes.substr(0, static_cast<std::size_t>(length));
}

VtuArrays::Bytes VtuArrays::decoded_bytes(const VtuArray& array, std::string& decoded) const {
  Decoded result = decode_base64(text_of(array));
  if (result.fault != std::string_view::npos)
    place(array.text + result.fault).fail("the data are not base64");
  decoded = std::move(result.bytes);
  return {decoded, place(array.start)};
}

VtuArrays::Bytes VtuArrays::appended_bytes(const VtuArray& array) const {
  std::uint64_t offset = 0;
  const char* const end = array.offset.data() + array.offset.size();
  const auto [stop, error] = std::from_chars(array.offset.data(), end, offset);
  if (error != std::errc() || stop != end)
    place(array.start).fail("offset " + quoted(array.offset) + " is not a number");
  if (appended_ == 0) place(array.start).fail("the file has no AppendedData");
  if (offset > contents_.size() - appended_)
    place(array.start).fail("offset " + std::to_string(offset) + " is beyond the end of the file");
  const std::size_t start = appended_ + static_cast<std::size_t>(offset);
  return {contents_.substr(start), {contents_, name_, start, true}};
}

void VtuArrays::require_apart(const Bytes& bytes) {
  appended_used_ += bytes.bytes.size();
  if (appended_used_ > contents_.size() - appended_) bytes.place.fail("appended arrays overlap");
}

VtuArrays::Bytes VtuArrays::bytes_of(const VtuArray& array, Scalar type, std::int64_t count,
                                     std::string& decoded) {
  require_readable(array);
  const bool inside = array.format == "binary";
  if (!inside && array.format != "appended")
    place(array.start).fail("DataArray of unknown format " + quoted(array.format));
  Bytes bytes = inside ? decoded_bytes(array, decoded) : appended_bytes(array);
  take_header(bytes, inside);
  if (!inside) require_apart(bytes);
  if (bytes.bytes.size() % size_of(type) != 0 ||
      bytes.bytes.size() / size_of(type) != static_cast<std::uint64_t>(count))
    bytes.place.fail(std::to_string(bytes.bytes.size()) + " bytes for " + std::to_string(count) +
                     " numbers of type " + std::string(array.type));
  return bytes;
}

Source VtuArrays::text_source(const VtuArray& array) const {
  const std::string_view text = text_of(array);
  Source source(contents_.substr(0, array.text + text.size()), name_);
  source.seek(array.text);
  return source;
}

void VtuArrays::require_end(Source& source) const {
  if (!source.empty()) source.fail("more numbers in the DataArray than the file has items");
}

std::vector<double> VtuArrays::points(const VtuArray& array, std::int64_t count) {
  const Scalar type = type_of(array);
  if (array.components != "3") place(array.start).fail("points without NumberOfComponents=\"3\"");
  const std::size_t numbers = 3 * static_cast<std::size_t>(count);
  if (array.format == "ascii") {
    Source source = text_source(array);
    source.checked_count(count, "number of points", 6, place(array.start));
    std::vector<double> values = source.coordinates(type, numbers);
    require_end(source);
    return values;
  }
  std::string decoded;
  const Bytes bytes = bytes_of(array, type, static_cast<std::int64_t>(numbers), decoded);
  std::vector<double> values(numbers);
  for (std::size_t i = 0; i < numbers; ++i) {
    values[i] = load_real(bytes.bytes.data() + i * size_of(type), type, swap());
    if (!std::isfinite(values[i]))
      bytes.place.fail("point " + std::to_string(i / 3) + ": " + axis_labels[i % 3] + " is not finite");
  }
  return values;
}

std::vector<std::int64_t> VtuArrays::integers(const VtuArray& array, std::int64_t count, const char* what) {
  const Scalar type = type_of(array);
  if (is_real(type)) place(array.start).fail(std::string(what) + " of the cells are not integers");
  if (array.format == "ascii") {
    Source source = text_source(array);
    source.checked_count(count, what, 2, place(array.start));
    std::vector<std::int64_t> values = source.integers(type, static_cast<std::size_t>(count), what);
    require_end(source);
    return values;
  }
  std::string decoded;
  const Bytes bytes = bytes_of(array, type, count, decoded);
  std::vector<std::int64_t> values(static_cast<std::size_t>(count));
  for (std::size_t i = 0; i < values.size(); ++i)
    values[i] = load_integer(bytes.bytes.data() + i * size_of(type), type, swap());
  return values;
}

}  // namespace isostretch::mesh
