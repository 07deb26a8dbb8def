#include "file.hpp"
#include "input_cursor.hpp"

#include <isostretch/core/error.hpp>
#include <isostretch/mesh_io/io.hpp>

#include <array>
#include <filesystem>
#include <utility>

namespace isostretch::mesh {
namespace {

template <class Function>
struct Entry {
  const char* extension;
  Function function;
};

// What handles the extension of the path; an Error with the list of those that there are.
template <class Function, std::size_t Size>
Function find(const std::array<Entry<Function>, Size>& formats, const std::string& path) {
  const std::string extension = lower(std::filesystem::path(path).extension().string());
  std::string known;
  for (const auto& format : formats) {
    if (extension == format.extension) return format.function;
    known += std::string(known.empty() ? "" : ", ") + format.extension;
  }
  throw Error(path + ": cannot tell the format: the name ends in none of " + known);
}

using SurfaceReader = SurfaceMesh (*)(const std::string&, const ReadOptions&);
using TetReader = TetMesh (*)(const std::string&, const ReadOptions&);
using SurfaceWriter = void (*)(const std::string&, const SurfaceMesh&, const WriteOptions&);
using TetWriter = void (*)(const std::string&, const TetMesh&, const WriteOptions&);

constexpr std::array<Entry<SurfaceReader>, 8> surface_readers = {{{".obj", read_obj},
                                                                  {".off", read_off},
                                                                  {".ply", read_ply},
                                                                  {".stl", read_stl},
                                                                  {".msh", read_msh_surface},
                                                                  {".mesh", read_medit_surface},
                                                                  {".vtk", read_vtk_surface},
                                                                  {".vtu", read_vtu_surface}}};
constexpr std::array<Entry<TetReader>, 6> tet_readers = {{{".msh", read_msh_tets},
                                                          {".mesh", read_medit_tets},
                                                          {".vtk", read_vtk_tets},
                                                          {".vtu", read_vtu_tets},
                                                          {".node", read_tetgen_tets},
                                                          {".ele", read_tetgen_tets}}};

using ElementReader = ElementMesh (*)(const std::string&, const ReadOptions&);

template <ElementMesh (*parse)(std::string_view, const std::string&, const ReadOptions&)>
ElementMesh from_file(const std::string& path, const ReadOptions& options) {
  return parse(read_file(path), path, options);
}

// Of a format that knows faces only.
template <SurfaceReader read>
ElementMesh from_surface(const std::string& path, const ReadOptions& options) {
  SurfaceMesh surface = read(path, options);
  return {Shape::triangle, std::move(surface.vertices), surface.triangles, {}};
}

constexpr std::array<Entry<ElementReader>, 10> element_readers = {{{".msh", from_file<parse_msh_elements>},
                                                                   {".mesh", from_file<parse_medit_elements>},
                                                                   {".vtk", from_file<parse_vtk_elements>},
                                                                   {".vtu", from_file<parse_vtu_elements>},
                                                                   {".node", read_tetgen_elements},
                                                                   {".ele", read_tetgen_elements},
                                                                   {".obj", from_surface<read_obj>},
                                                                   {".off", from_surface<read_off>},
                                                                   {".ply", from_surface<read_ply>},
                                                                   {".stl", from_surface<read_stl>}}};

// Those that have one encoding.
template <class Mesh, void (*write)(const std::string&, const Mesh&)>
void ignoring_options(const std::string& path, const Mesh& mesh, const WriteOptions&) {
  write(path, mesh);
}
void glb_of_surface(const std::string& path, const SurfaceMesh& mesh, const WriteOptions&) {
  write_glb(path, mesh);
}

constexpr std::array<Entry<SurfaceWriter>, 8> surface_writers = {
    {{".obj", ignoring_options<SurfaceMesh, write_obj>},
     {".off", ignoring_options<SurfaceMesh, write_off>},
     {".ply", write_ply},
     {".msh", write_msh},
     {".mesh", ignoring_options<SurfaceMesh, write_medit>},
     {".vtk", write_vtk},
     {".vtu", write_vtu},
     {".glb", glb_of_surface}}};
constexpr std::array<Entry<TetWriter>, 4> tet_writers = {{{".msh", write_msh},
                                                          {".mesh", ignoring_options<TetMesh, write_medit>},
                                                          {".vtk", write_vtk},
                                                          {".vtu", write_vtu}}};

}  // namespace

SurfaceMesh read_surface(const std::string& path, const ReadOptions& options) {
  return find(surface_readers, path)(path, options);
}

TetMesh read_tets(const std::string& path, const ReadOptions& options) {
  return find(tet_readers, path)(path, options);
}

ElementMesh read_elements(const std::string& path, const ReadOptions& options) {
  return find(element_readers, path)(path, options);
}

void write_surface(const std::string& path, const SurfaceMesh& mesh, const WriteOptions& options) {
  find(surface_writers, path)(path, mesh, options);
}

void write_tets(const std::string& path, const TetMesh& mesh, const WriteOptions& options) {
  find(tet_writers, path)(path, mesh, options);
}

}  // namespace isostretch::mesh
