#include "vtu_arrays.hpp"

#include "characters.hpp"
#include "input_cursor.hpp"
#include "number.hpp"
#include "zlib.hpp"

#include <isostretch/core/base64.hpp>

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

// Raw, or in base64.
class VtuArrays::Bytes {
 public:
  Bytes(std::string_view contents, bool base64, const Place& place)
      : contents_(contents), base64_(base64), stream_(contents), place_(place) {}

  std::size_t left() const {
    return base64_ ? 3 * (contents_.size() - stream_.position()) / 4 + 3 : contents_.size() - used_;
  }
  std::size_t used() const { return base64_ ? stream_.position() : used_; }
  bool at_end() const { return base64_ ? stream_.at_end() : used_ == contents_.size(); }
  const Place& place() const { return place_; }

  // `kept` has what was decoded.
  std::string_view take(std::uint64_t count, std::string& kept) {
    if (base64_) {
      if (count > left() || !stream_.take(static_cast<std::size_t>(count), kept))
        place_.fail("the data end early or are not base64");
      return kept;
    }
    if (count > left())
      place_.fail("array of " + std::to_string(count) + " bytes, where " + std::to_string(left()) +
                  " are left");
    const auto size = static_cast<std::size_t>(count);
    used_ += size;
    return contents_.substr(used_ - size, size);
  }

 private:
  std::string_view contents_;
  bool base64_;
  Base64Stream stream_;
  std::size_t used_ = 0;  // of raw bytes
  Place place_;
};

void VtuArrays::require_readable(const VtuArray& array) const {
  if (!coding_.compressor.empty() && coding_.compressor != "vtkZLibDataCompressor")
    place(array.start)
        .fail("data compressed by " + quoted(coding_.compressor) +
              " are not read, only those by vtkZLibDataCompressor");
  if (!coding_.has_byte_order) place(array.start).fail("binary data in a file without byte_order");
}

std::uint64_t VtuArrays::header_number(Bytes& bytes) const {
  std::string kept;
  const std::size_t size = size_of(coding_.header);
  return static_cast<std::uint64_t>(load_integer(bytes.take(size, kept).data(), coding_.header, swap()));
}

std::size_t VtuArrays::appended_start(const VtuArray& array) const {
  const std::string_view text = trimmed(array.offset);
  std::uint64_t offset = 0;
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), offset);
  if (error != std::errc() || stop != text.data() + text.size())
    place(array.start).fail("offset " + quoted(array.offset) + " is not a number");
  if (appended_ == 0) place(array.start).fail("the file has no AppendedData");
  if (offset > contents_.size() - appended_)
    place(array.start).fail("offset " + std::to_string(offset) + " is beyond the end of the file");
  return appended_ + static_cast<std::size_t>(offset);
}

// Of raw data by byte.
Place VtuArrays::data_place(const VtuArray& array) const {
  if (array.format != "appended" || appended_base64_) return place(array.start);
  return {contents_, name_, appended_start(array), true};
}

VtuArrays::Bytes VtuArrays::bytes_of(const VtuArray& array) const {
  if (array.format == "binary") return {text_of(array), true, data_place(array)};
  if (array.format != "appended")
    place(array.start).fail("DataArray of unknown format " + quoted(array.format));
  const std::string_view rest = contents_.substr(appended_start(array));
  return {appended_base64_ ? rest.substr(0, rest.find('<')) : rest, appended_base64_, data_place(array)};
}

void VtuArrays::require_apart(const Bytes& bytes) {
  appended_used_ += bytes.used();
  if (appended_used_ > contents_.size() - appended_) bytes.place().fail("appended arrays overlap");
}

// In front: the number of blocks, their size inflated, that of the last one if it is smaller, and the sizes
// of all as they are in the file.
void VtuArrays::inflate(Bytes& bytes, std::uint64_t size, std::string& numbers) const {
  const std::uint64_t blocks = header_number(bytes), block_size = header_number(bytes),
                      partial = header_number(bytes);
  if (blocks > bytes.left() / size_of(coding_.header))
    bytes.place().fail(std::to_string(blocks) + " compressed blocks are more than the file can hold");
  std::vector<std::uint64_t> sizes;
  for (std::uint64_t b = 0; b < blocks; ++b) sizes.push_back(header_number(bytes));
  std::string kept;
  for (std::uint64_t b = 0; b < blocks; ++b) {
    const std::uint64_t inflated = b + 1 == blocks && partial > 0 ? partial : block_size;
    const std::uint64_t compressed = sizes[static_cast<std::size_t>(b)];
    if (inflated > largest_inflated(compressed) || inflated > size - numbers.size())
      bytes.place().fail("block " + std::to_string(b) + " of " + std::to_string(inflated) +
                         " bytes, which is more than it can hold or the array needs");
    if (!append_inflated(numbers, bytes.take(compressed, kept), static_cast<std::size_t>(inflated)))
      bytes.place().fail("block " + std::to_string(b) + " is not compressed as zlib does");
  }
}

std::string_view VtuArrays::numbers_of(const VtuArray& array, Scalar type, std::int64_t count,
                                       std::string& kept) {
  require_readable(array);
  Bytes bytes = bytes_of(array);
  const std::uint64_t wanted = static_cast<std::uint64_t>(count) * size_of(type);
  std::string_view numbers;
  if (coding_.compressor.empty()) {
    const std::uint64_t length = header_number(bytes);
    if (length > bytes.left() || length == wanted)
      numbers = bytes.take(length, kept);
    else
      bytes.place().fail(std::to_string(length) + " bytes for " + std::to_string(count) +
                         " numbers of type " + std::string(array.type));
  } else {
    inflate(bytes, wanted, kept);
    numbers = kept;
  }
  if (numbers.size() != wanted)
    bytes.place().fail(std::to_string(numbers.size()) + " bytes for " + std::to_string(count) +
                       " numbers of type " + std::string(array.type));
  if (array.format == "appended")
    require_apart(bytes);
  else if (!bytes.at_end())
    bytes.place().fail("the DataArray goes on behind its " + std::to_string(numbers.size()) + " bytes");
  return numbers;
}

InputCursor VtuArrays::text_source(const VtuArray& array) const {
  const std::string_view text = text_of(array);
  InputCursor cursor(contents_.substr(0, array.text + text.size()), name_);
  cursor.seek(array.text);
  return cursor;
}

void VtuArrays::require_end(InputCursor& cursor) const {
  if (!cursor.empty()) cursor.fail("more numbers in the DataArray than the file has items");
}

int component_count(const VtuArray& array) {
  const std::string_view text = trimmed(array.components);
  if (text.empty()) return 1;
  return text.size() == 1 && text[0] >= '1' && text[0] <= '3' ? text[0] - '0' : 0;
}

std::vector<double> VtuArrays::tuples(const VtuArray& array, std::int64_t count, const char* what) {
  const Scalar type = type_of(array);
  const auto each = static_cast<std::size_t>(component_count(array));
  if (each == 0)
    place(array.start).fail(std::string(what) + "s of " + quoted(array.components) + " components");
  const std::size_t numbers = each * static_cast<std::size_t>(count);
  if (array.format == "ascii") {
    InputCursor cursor = text_source(array);
    cursor.checked_count(count, "number of points", 2 * each, place(array.start));
    std::vector<double> values = cursor.coordinates(type, numbers);
    require_end(cursor);
    return values;
  }
  std::string kept;
  const std::string_view bytes = numbers_of(array, type, static_cast<std::int64_t>(numbers), kept);
  std::vector<double> values(numbers);
  for (std::size_t i = 0; i < numbers; ++i) {
    values[i] = load_real(bytes.data() + i * size_of(type), type, swap());
    if (!std::isfinite(values[i]))
      data_place(array).fail(std::string(what) + " " + std::to_string(i / each) + ": " +
                             axis_labels[i % each] + " is not finite");
  }
  return values;
}

std::vector<std::int64_t> VtuArrays::integers(const VtuArray& array, std::int64_t count, const char* what) {
  const Scalar type = type_of(array);
  if (is_real(type)) place(array.start).fail(std::string(what) + " of the cells are not integers");
  if (array.format == "ascii") {
    InputCursor cursor = text_source(array);
    cursor.checked_count(count, what, 2, place(array.start));
    std::vector<std::int64_t> values = cursor.integers(type, static_cast<std::size_t>(count), what);
    require_end(cursor);
    return values;
  }
  std::string kept;
  const std::string_view bytes = numbers_of(array, type, count, kept);
  std::vector<std::int64_t> values(static_cast<std::size_t>(count));
  for (std::size_t i = 0; i < values.size(); ++i)
    values[i] = load_integer(bytes.data() + i * size_of(type), type, swap());
  return values;
}

}  // namespace isostretch::mesh
