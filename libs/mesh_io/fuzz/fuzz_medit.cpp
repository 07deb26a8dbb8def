#include "fuzz_reader.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  isostretch::mesh::fuzz::read(data, size, isostretch::mesh::parse_medit_surface);
  isostretch::mesh::fuzz::read(data, size, isostretch::mesh::parse_medit_tets);
  isostretch::mesh::fuzz::read_elements(data, size, isostretch::mesh::parse_medit_elements);
  return 0;
}
