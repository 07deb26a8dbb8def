#pragma once

#include <isostretch/mesh/types.hpp>

#include <string>
#include <string_view>

namespace isostretch::mesh {

struct ReadOptions {
  // A face of more than three vertices is cut into a fan around its first vertex (right for convex faces);
  // otherwise it is refused.
  bool triangulate_polygons = false;
  // OBJ: take texture coordinates. Either every face has them or none; false ignores them.
  bool read_uv = true;
};

// Every fault throws Error "path:line: what": numbers that do not parse or are not finite, indices out of
// range, faces with fewer than three vertices, a file that ends early; a file without faces, or one that
// cannot be opened. Reading does not depend on the locale. What is read is not checked further: see
// check.hpp.

// Wavefront OBJ: v, vt and f, with negative indices, line continuations and CRLF. Normals, groups, materials,
// colours after a vertex and every other statement are skipped.
SurfaceMesh read_obj(const std::string& path, const ReadOptions& options = {});
// The same from memory; `name` stands for the path in messages.
SurfaceMesh parse_obj(std::string_view text, const std::string& name, const ReadOptions& options = {});

// Object File Format in text, with comments; colours, normals and texture coordinates of vertices and faces
// are skipped.
SurfaceMesh read_off(const std::string& path, const ReadOptions& options = {});
SurfaceMesh parse_off(std::string_view text, const std::string& name, const ReadOptions& options = {});

// By the extension: .obj or .off in any case.
SurfaceMesh read_surface(const std::string& path, const ReadOptions& options = {});

// Shortest decimal numbers that read back to the same bits. The file appears complete or not at all. Throws
// Error when it cannot be written, or naming the vertex or triangle when the mesh has a coordinate that is
// not finite or an index out of range.
void write_obj(const std::string& path, const SurfaceMesh& mesh);
std::string format_obj(const SurfaceMesh& mesh);

}  // namespace isostretch::mesh
