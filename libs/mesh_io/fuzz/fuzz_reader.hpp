#pragma once

// What the fuzzers of all readers share. An Error is the right answer to a bad file; everything else that is
// not a mesh with valid indices and finite coordinates is a defect.
#include <isostretch/core/error.hpp>
#include <isostretch/mesh_io/io.hpp>
#include <isostretch/surface/check.hpp>
#include <isostretch/surface/repair.hpp>

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace isostretch::mesh::fuzz {

// The last byte chooses the options too: seeds stay plain files.
inline ReadOptions options_from(std::string_view contents) {
  const unsigned last = contents.empty() ? 0 : static_cast<unsigned char>(contents.back());
  ReadOptions options;
  options.leave_out_faces = (last & 1u) != 0;
  options.read_uv = (last & 2u) != 0;
  options.weld = (last & 4u) == 0;
  options.weld_tolerance = (last & 8u) != 0 ? 1e-3 : 0;
  return options;
}

template <class Parse>
void read(const std::uint8_t* data, std::size_t size, const Parse& parse) {
  const std::string_view contents(reinterpret_cast<const char*>(data), size);
  try {
    const MeshDiagnostics report = check(parse(contents, "input", options_from(contents)));
    if (!report.indices_valid || report.count(DefectKind::not_finite) > 0) __builtin_trap();
  } catch (const Error&) {
    return;
  }
}

// The same of elements of any kind.
template <class Parse>
void read_elements(const std::uint8_t* data, std::size_t size, const Parse& parse) {
  const std::string_view contents(reinterpret_cast<const char*>(data), size);
  try {
    ElementMesh mesh = parse(contents, "input", options_from(contents));
    const int count = static_cast<int>(mesh.elements.rows());
    if (count == 0 || mesh.elements.minCoeff() < 0 || mesh.elements.maxCoeff() >= mesh.vertices.rows() ||
        !mesh.vertices.allFinite() || mesh.elements.cols() != shape_node_count(mesh.shape))
      __builtin_trap();
    for (const ElementGroup& group : mesh.groups)
      for (const int e : group.elements)
        if (e < 0 || e >= count) __builtin_trap();
    for (const ElementGroup& group : mesh.groups)
      for (const int v : group.vertices)
        if (v < 0 || v >= mesh.vertices.rows()) __builtin_trap();
    repair(mesh);
  } catch (const Error&) {
    return;
  }
}

}  // namespace isostretch::mesh::fuzz
