#pragma once

#include <isostretch/mesh/types.hpp>
#include <isostretch/mesh_io/io.hpp>

#include <memory>
#include <string>
#include <string_view>

namespace isostretch::mesh {

/// The text of an OBJ file with new texture coordinates, and a record of what could not be kept in it.
struct ObjText {
  std::string text;       ///< Contents of the file.
  int divided_faces = 0;  ///< Polygons written as triangles, since texture coordinates differ inside them.
  int removed_faces = 0;  ///< Faces of which no triangle was to be written.
  bool names_materials = false;  ///< Whether statements mtllib name files, which are sought beside this one.
  int lines_without_uv = 0;      ///< Statements l that lost their texture coordinates.
};

/// An OBJ file that is kept as it stands beside the mesh read from it, so that it can be written again with
/// other texture coordinates. Everything else stays to the letter: the order of vertices and their colours,
/// faces of any number of corners, normals, objects, groups, smoothing, materials, comments.
class ObjDocument {
 public:
  /// Reads a document from memory. `name` stands for the path in messages. Throws Error as parse_obj() does.
  static ObjDocument parse(std::string text, const std::string& name, const ReadOptions& options = {});
  /// Reads a document from a file. Throws Error as read_obj() does.
  static ObjDocument read(const std::string& path, const ReadOptions& options = {});

  /// Takes over the other document, which is left to be destroyed or assigned to.
  ObjDocument(ObjDocument&&) noexcept;
  /// Takes over the other document, which is left to be destroyed or assigned to.
  ObjDocument& operator=(ObjDocument&&) noexcept;
  ~ObjDocument();

  /// Returns the mesh that parse_obj() makes of the document: faces of more corners are cut into triangles.
  const SurfaceMesh& mesh() const;

  /// Returns the document with the texture coordinates `uv` in place of its own. `corners` has a row for
  /// every triangle of mesh(): indices into uv, or -1 for a triangle that is to be left out. A polygon inside
  /// which two triangles have different coordinates at one corner is written as its triangles. Throws Error
  /// for a wrong number of rows, an index out of range or a coordinate that is not finite.
  ObjText with_uv(const Points2& uv, const Triangles& corners) const;

 private:
  struct Contents;
  explicit ObjDocument(std::unique_ptr<Contents> contents);
  std::unique_ptr<Contents> contents_;
};

}  // namespace isostretch::mesh
