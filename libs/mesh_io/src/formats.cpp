// The one table of formats: those built in, and those registered from outside.
#include "file.hpp"
#include "input_cursor.hpp"

#include <isostretch/core/error.hpp>
#include <isostretch/mesh_io/format.hpp>

#include <algorithm>
#include <deque>
#include <filesystem>
#include <mutex>
#include <utility>

namespace isostretch::mesh {
namespace {

template <ElementMesh (*parse)(std::string_view, const std::string&, const ReadOptions&)>
ElementMesh from_file(const std::string& path, const ReadOptions& options) {
  return parse(read_file(path), path, options);
}

// Writers of formats that have one encoding.
template <class Mesh, void (*write)(const std::string&, const Mesh&)>
void ignoring_options(const std::string& path, const Mesh& mesh, const WriteOptions&) {
  write(path, mesh);
}
void glb_of_surface(const std::string& path, const SurfaceMesh& mesh, const WriteOptions&) {
  write_glb(path, mesh);
}

// Overloads by the kind of mesh.
constexpr auto write_msh_surface =
    static_cast<void (*)(const std::string&, const SurfaceMesh&, const WriteOptions&)>(write_msh);
constexpr auto write_msh_tets =
    static_cast<void (*)(const std::string&, const TetMesh&, const WriteOptions&)>(write_msh);
constexpr auto write_vtk_surface =
    static_cast<void (*)(const std::string&, const SurfaceMesh&, const WriteOptions&)>(write_vtk);
constexpr auto write_vtk_tets =
    static_cast<void (*)(const std::string&, const TetMesh&, const WriteOptions&)>(write_vtk);
constexpr auto write_vtu_surface =
    static_cast<void (*)(const std::string&, const SurfaceMesh&, const WriteOptions&)>(write_vtu);
constexpr auto write_vtu_tets =
    static_cast<void (*)(const std::string&, const TetMesh&, const WriteOptions&)>(write_vtu);

std::deque<Format> built_in() {
  return {
      {".obj", read_obj, {}, {}, ignoring_options<SurfaceMesh, write_obj>, {}},
      {".off", read_off, {}, {}, ignoring_options<SurfaceMesh, write_off>, {}},
      {".ply", read_ply, {}, {}, write_ply, {}},
      {".stl", read_stl, {}, {}, {}, {}},
      {".msh", read_msh_surface, read_msh_tets, from_file<parse_msh_elements>, write_msh_surface,
       write_msh_tets},
      {".mesh", read_medit_surface, read_medit_tets, from_file<parse_medit_elements>,
       ignoring_options<SurfaceMesh, write_medit>, ignoring_options<TetMesh, write_medit>},
      {".vtk", read_vtk_surface, read_vtk_tets, from_file<parse_vtk_elements>, write_vtk_surface,
       write_vtk_tets},
      {".vtu", read_vtu_surface, read_vtu_tets, from_file<parse_vtu_elements>, write_vtu_surface,
       write_vtu_tets},
      {".node", {}, read_tetgen_tets, read_tetgen_elements, {}, {}},
      {".ele", {}, read_tetgen_tets, read_tetgen_elements, {}, {}},
      {".glb", {}, {}, {}, glb_of_surface, {}},
  };
}

// Entries stay where they are once they are in.
struct Registry {
  std::mutex mutex;
  std::deque<Format> formats = built_in();
};

Registry& registry() {
  static Registry only;
  return only;
}

// The format of the path's extension, which must be able to do that; an Error lists those that are.
template <class Can>
const Format& format_of(const std::string& path, const Can& can) {
  const std::string extension = lower(std::filesystem::path(path).extension().string());
  std::string known;
  Registry& all = registry();
  const std::lock_guard lock(all.mutex);
  for (const Format& format : all.formats) {
    if (!can(format)) continue;
    if (extension == format.extension) return format;
    known.append(known.empty() ? "" : ", ").append(format.extension);
  }
  throw Error(path + ": cannot tell the format: the name ends in none of " + known);
}

}  // namespace

void register_format(Format format) {
  const std::string& extension = format.extension;
  if (extension.size() < 2 || extension[0] != '.' || extension != lower(extension) ||
      extension.find_first_of("./", 1) != std::string::npos)
    throw Error(ErrorKind::misuse,
                "register_format: '" + extension + "' is no extension: a dot and small letters are wanted");
  if (!format.read_surface && !format.read_tets && !format.read_elements && !format.write_surface &&
      !format.write_tets)
    throw Error(ErrorKind::misuse, "register_format: '" + extension + "' neither reads nor writes");
  Registry& all = registry();
  const std::lock_guard lock(all.mutex);
  if (std::any_of(all.formats.begin(), all.formats.end(),
                  [&](const Format& known) { return known.extension == extension; }))
    throw Error(ErrorKind::misuse, "register_format: the extension '" + extension + "' is taken");
  all.formats.push_back(std::move(format));
}

SurfaceMesh read_surface(const std::string& path, const ReadOptions& options) {
  return format_of(path, [](const Format& f) { return bool(f.read_surface); }).read_surface(path, options);
}

TetMesh read_tets(const std::string& path, const ReadOptions& options) {
  return format_of(path, [](const Format& f) { return bool(f.read_tets); }).read_tets(path, options);
}

ElementMesh read_elements(const std::string& path, const ReadOptions& options) {
  const Format& format = format_of(path, [](const Format& f) { return f.read_elements || f.read_surface; });
  if (format.read_elements) return format.read_elements(path, options);
  SurfaceMesh surface = format.read_surface(path, options);
  return {Shape::triangle, std::move(surface.vertices), surface.triangles, {}};
}

void write_surface(const std::string& path, const SurfaceMesh& mesh, const WriteOptions& options) {
  format_of(path, [](const Format& f) { return bool(f.write_surface); }).write_surface(path, mesh, options);
}

void write_tets(const std::string& path, const TetMesh& mesh, const WriteOptions& options) {
  format_of(path, [](const Format& f) { return bool(f.write_tets); }).write_tets(path, mesh, options);
}

}  // namespace isostretch::mesh
