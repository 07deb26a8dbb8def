#pragma once

#include "input_cursor.hpp"
#include "place.hpp"
#include "scalar.hpp"
#include "xml.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace isostretch::mesh {

// What the outermost tag of a VTK XML file says of numbers.
struct VtuCoding {
  bool big_endian = false;
  bool has_byte_order = false;
  std::string_view compressor;     // empty: none
  Scalar header = Scalar::uint32;  // of numbers of bytes in front of an array
};

// A DataArray as its tag describes it, not read yet.
struct VtuArray {
  bool present = false;
  std::size_t start = 0;  // of the tag
  std::string_view type;
  std::string_view format;
  std::string_view offset;
  std::string_view components;
  std::size_t text = 0;  // behind the tag
};

VtuArray describe_array(const XmlTag& tag);
// Numbers a tuple, or 0 where they are not one to three.
int component_count(const VtuArray& array);

// Reads arrays of one file. Failures name the line of the tag, or the byte of raw data.
class VtuArrays {
 public:
  VtuArrays(std::string_view contents, const std::string& name) : contents_(contents), name_(name) {}

  void set_coding(const VtuCoding& coding) { coding_ = coding; }
  // Where appended data begin, behind the underscore, raw or in base64.
  void set_appended(std::size_t start, bool base64) {
    appended_ = start;
    appended_base64_ = base64;
  }

  // Finite numbers, as many a tuple as the array says, one to three; `what` names a tuple.
  std::vector<double> tuples(const VtuArray& array, std::int64_t count, const char* what);
  std::vector<std::int64_t> integers(const VtuArray& array, std::int64_t count, const char* what);

  Place place(std::size_t position) const { return {contents_, name_, position, false}; }

 private:
  // The bytes of one array, taken from the front.
  class Bytes;

  Scalar type_of(const VtuArray& array) const;
  std::string_view text_of(const VtuArray& array) const;
  // Of a text array, and nothing but these.
  InputCursor text_source(const VtuArray& array) const;
  void require_end(InputCursor& cursor) const;
  // The numbers of the array as they are in memory; `bytes` keeps them.
  std::string_view numbers_of(const VtuArray& array, Scalar type, std::int64_t count, std::string& bytes);
  Bytes bytes_of(const VtuArray& array) const;
  Place data_place(const VtuArray& array) const;
  std::size_t appended_start(const VtuArray& array) const;
  void require_readable(const VtuArray& array) const;
  std::uint64_t header_number(Bytes& bytes) const;
  void inflate(Bytes& bytes, std::uint64_t size, std::string& numbers) const;
  // Arrays that share their bytes would make a small file a large mesh.
  void require_apart(const Bytes& bytes);
  bool swap() const { return coding_.big_endian != (std::endian::native == std::endian::big); }

  std::string_view contents_;
  const std::string& name_;
  VtuCoding coding_;
  std::size_t appended_ = 0;
  bool appended_base64_ = false;
  std::size_t appended_used_ = 0;  // bytes of the file, of all arrays so far
};

}  // namespace isostretch::mesh
