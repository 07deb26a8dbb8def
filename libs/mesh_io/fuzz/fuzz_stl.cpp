#include "fuzz_reader.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  isostretch::mesh::fuzz::read(data, size, isostretch::mesh::parse_stl);
  return 0;
}
