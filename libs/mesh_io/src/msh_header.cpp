#include "msh_header.hpp"

#include "characters.hpp"
#include "number.hpp"

#include <string>

namespace isostretch::mesh {
namespace {

MshVersion version_of(InputCursor& cursor) {
  const std::string_view given = cursor.word();
  if (given == "2" || given == "2.0" || given == "2.1" || given == "2.2") return MshVersion::v2_2;
  if (given == "4" || given == "4.0") return MshVersion::v4_0;
  if (given != "4.1") cursor.fail("version " + quoted(given) + " is none of 2.0 to 2.2, 4.0 and 4.1");
  return MshVersion::v4_1;
}

// A one in the byte order of the file.
void read_byte_order(InputCursor& cursor) {
  cursor.line();
  cursor.set_coding(Coding::little_endian);
  const std::size_t start = cursor.position();
  if (cursor.integer(Scalar::int32, "number 1") == 1) return;
  cursor.seek(start);
  cursor.set_coding(Coding::big_endian);
  if (cursor.integer(Scalar::int32, "number 1") != 1) cursor.fail("a number 1 should follow the format");
}

}  // namespace

MshVersion read_msh_header(InputCursor& cursor) {
  if (cursor.word() != "$MeshFormat") cursor.fail("not an MSH file: it does not begin with $MeshFormat");
  const MshVersion version = version_of(cursor);
  const std::int64_t type = cursor.text_integer("file type");
  if (type != 0 && type != 1) cursor.fail("file type " + std::to_string(type) + " is neither 0 nor 1");
  if (cursor.text_integer("data size") != 8) cursor.fail("data size is not 8");
  if (type == 1) read_byte_order(cursor);
  expect_word(cursor, "$EndMeshFormat");
  return version;
}

void expect_word(InputCursor& cursor, const char* word) {
  const std::string_view found = cursor.word();
  if (found != word)
    cursor.fail(found.empty() ? std::string("the file ends where ") + word + " should be"
                              : std::string(word) + " expected, not " + quoted(found));
}

}  // namespace isostretch::mesh
