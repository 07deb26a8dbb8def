#include "fuzz_reader.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  isostretch::mesh::fuzz::read(data, size, isostretch::mesh::parse_vtk_surface);
  isostretch::mesh::fuzz::read(data, size, isostretch::mesh::parse_vtk_tets);
  isostretch::mesh::fuzz::read_elements(data, size, isostretch::mesh::parse_vtk_elements);
  return 0;
}
