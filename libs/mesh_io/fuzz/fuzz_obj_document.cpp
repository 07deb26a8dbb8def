#include "fuzz_reader.hpp"

#include <isostretch/mesh_io/obj_document.hpp>

#include <optional>
#include <string>

// What is written with the texture coordinates of the vertices has the same triangles.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace isostretch::mesh;
  const std::string_view contents(reinterpret_cast<const char*>(data), size);
  const auto options = fuzz::options_from(contents);
  std::optional<ObjDocument> document;
  try {
    document.emplace(ObjDocument::parse(std::string(contents), "input", options));
  } catch (const isostretch::Error&) {
    return 0;
  }
  const SurfaceMesh& mesh = document->mesh();
  const Points2 uv = mesh.vertices.leftCols<2>();
  const SurfaceMesh back = parse_obj(document->with_uv(uv, mesh.triangles).text, "output");
  if (back.vertices != mesh.vertices || back.triangles != mesh.triangles ||
      back.uv_triangles != mesh.triangles)
    __builtin_trap();
  return 0;
}
