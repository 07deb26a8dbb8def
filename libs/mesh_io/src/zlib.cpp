#include "zlib.hpp"

#include <isostretch/core/error.hpp>

#include <zlib.h>

namespace isostretch::mesh {

bool append_inflated(std::string& bytes, std::string_view stream, std::size_t size) {
  const std::size_t before = bytes.size();
  bytes.resize(before + size);
  uLongf got = static_cast<uLongf>(size);
  uLong used = static_cast<uLong>(stream.size());
  const int result = uncompress2(reinterpret_cast<Bytef*>(bytes.data() + before), &got,
                                 reinterpret_cast<const Bytef*>(stream.data()), &used);
  return result == Z_OK && got == size && used == stream.size();
}

std::string deflated(std::string_view bytes) {
  uLongf size = compressBound(static_cast<uLong>(bytes.size()));
  std::string stream(size, '\0');
  const int result = compress(reinterpret_cast<Bytef*>(stream.data()), &size,
                              reinterpret_cast<const Bytef*>(bytes.data()), static_cast<uLong>(bytes.size()));
  if (result != Z_OK) throw Error("zlib cannot compress " + std::to_string(bytes.size()) + " bytes");
  stream.resize(size);
  return stream;
}

}  // namespace isostretch::mesh
