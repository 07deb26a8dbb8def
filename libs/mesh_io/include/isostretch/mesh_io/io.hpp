#pragma once

#include <isostretch/mesh/element_mesh.hpp>
#include <isostretch/mesh/types.hpp>

#include <string>
#include <string_view>
#include <vector>

namespace isostretch::mesh {

struct ReadOptions {
  /// Faces that are none (of less than three vertices, or polygons that cross themselves or have no area) are
  /// left out, and the log told how many; otherwise they are refused.
  bool leave_out_faces = false;
  /// Ends the message about such a face: how the user has it left out.
  std::string face_advice = {};
  /// OBJ, PLY, OFF, VTK, VTU: take texture coordinates. Either every face has them or none; false ignores
  /// them.
  bool read_uv = true;
  /// STL, which knows corners only: equal corners become one vertex. Otherwise every triangle has three of
  /// its own.
  bool weld = true;
  /// Welding takes corners for equal up to this distance from the first of them. 0: the same numbers.
  double weld_tolerance = 0;
};

// Faces of more than three vertices, concave ones too, are cut into triangles along their diagonals, in the
// plane that fits them; triangles follow the order of the faces.
//
// Text is read alike in every format: lines end with \n, \r\n or \r alone, a byte-order mark in front is
// passed over, and a comment ends with its line.
//
// Every fault throws Error, "path:line: what" in text and "path: byte N: what" in binary: numbers that do not
// parse or are not finite, indices out of range, faces with fewer than three vertices, a file that ends
// early, one without any of the elements asked for, or one that cannot be opened. Memory is taken as the size
// of the file justifies, whatever counts it claims. Reading does not depend on the locale. What is read is
// not checked further: see check.hpp. Vertices keep the order of the file, those that no element uses
// included.
//
// `parse` functions read from memory; `name` stands for the path in messages.

/// By the extension, in any case: .obj .off .ply .stl .msh .mesh .vtk .vtu.
SurfaceMesh read_surface(const std::string& path, const ReadOptions& options = {});
/// .msh .mesh .vtk .vtu .node .ele.
TetMesh read_tets(const std::string& path, const ReadOptions& options = {});

enum class Encoding { text, binary };
enum class MshVersion { v2_2, v4_0, v4_1 };

struct WriteOptions {
  Encoding encoding = Encoding::binary;  ///< PLY, MSH, VTK, VTU; other formats have one encoding
  MshVersion msh_version = MshVersion::v4_1;
  bool vtu_base64 = false;  ///< binary VTU: base64 in every array instead of raw bytes at the end of the file
  bool vtu_compressed = false;  ///< binary VTU: arrays compressed by zlib
};

// Writers keep every bit: shortest decimal numbers that read back the same, or binary doubles. The file
// appears complete or not at all. They throw Error when it cannot be written, when the mesh has no elements,
// or naming the vertex or element with a coordinate that is not finite or an index out of range. `format`
// functions return the contents.

/// By the extension: .obj .off .ply .msh .mesh .vtk .vtu .glb.
void write_surface(const std::string& path, const SurfaceMesh& mesh, const WriteOptions& options = {});
/// .msh .mesh .vtk .vtu.
void write_tets(const std::string& path, const TetMesh& mesh, const WriteOptions& options = {});

/// Wavefront OBJ: v, vt and f, with negative indices and line continuations. Normals, groups, materials,
/// colours after a vertex and every other statement are skipped; obj_document.hpp keeps them.
SurfaceMesh read_obj(const std::string& path, const ReadOptions& options = {});
SurfaceMesh parse_obj(std::string_view text, const std::string& name, const ReadOptions& options = {});
void write_obj(const std::string& path, const SurfaceMesh& mesh);
std::string format_obj(const SurfaceMesh& mesh);

/// Object File Format in text, with comments; colours, normals and texture coordinates of vertices and faces
/// are skipped. Only OBJ, PLY and glTF hold texture coordinates; all other writers leave them out.
SurfaceMesh read_off(const std::string& path, const ReadOptions& options = {});
SurfaceMesh parse_off(std::string_view text, const std::string& name, const ReadOptions& options = {});
void write_off(const std::string& path, const SurfaceMesh& mesh);
std::string format_off(const SurfaceMesh& mesh);

/// Stanford PLY in text and in either byte order: x, y, z of vertices, and faces from the list vertex_indices
/// or vertex_index, in any types; other elements and properties are skipped. Texture coordinates are
/// properties of vertices (s and t, u and v, texture_u and texture_v, texture_s and texture_t) or, before
/// these, the list texcoord of faces. Written with doubles, binary in little endian, texture coordinates as s
/// and t unless a vertex has several.
SurfaceMesh read_ply(const std::string& path, const ReadOptions& options = {});
SurfaceMesh parse_ply(std::string_view contents, const std::string& name, const ReadOptions& options = {});
void write_ply(const std::string& path, const SurfaceMesh& mesh, const WriteOptions& options = {});
std::string format_ply(const SurfaceMesh& mesh, const WriteOptions& options = {});

/// STL, binary if the length is what its number of triangles makes, and text if it begins with solid;
/// normals, colours and names are skipped. What follows the triangles that a binary file counts is not read,
/// and the log told. Reading only.
SurfaceMesh read_stl(const std::string& path, const ReadOptions& options = {});
SurfaceMesh parse_stl(std::string_view contents, const std::string& name, const ReadOptions& options = {});

// The formats below hold elements of many kinds. Reading a surface takes triangles, quadrangles and polygons,
// and refuses faces of higher order. Reading tetrahedra takes those of four nodes, and refuses a file with
// other solid elements, naming how many of which kind. Reading elements takes those of the highest dimension
// in the file, which must be of one kind: triangles and tetrahedra, linear or of second order, quadrangles or
// hexahedra. Points, lines, the faces of a solid, entities, partitions and data are skipped.

/// Reads the elements of a body, and the groups they are in, by the extension: .msh .mesh .vtk .vtu .node
/// .ele, and of surfaces .obj .off .ply .stl, whose faces become triangles.
ElementMesh read_elements(const std::string& path, const ReadOptions& options = {});

/// Gmsh MSH, versions 2.0 to 2.2, 4.0 and 4.1, text and binary of either byte order. Node tags may have gaps;
/// vertices are in the order of the file. An element that is there several times under one number, or in
/// version 2 once for each of its physical groups, is one element; different ones under one number are
/// refused.
SurfaceMesh read_msh_surface(const std::string& path, const ReadOptions& options = {});
SurfaceMesh parse_msh_surface(std::string_view contents, const std::string& name,
                              const ReadOptions& options = {});
TetMesh read_msh_tets(const std::string& path, const ReadOptions& options = {});
TetMesh parse_msh_tets(std::string_view contents, const std::string& name, const ReadOptions& options = {});
/// Reads the elements of a body from memory, see read_elements().
ElementMesh parse_msh_elements(std::string_view contents, const std::string& name,
                               const ReadOptions& options = {});
void write_msh(const std::string& path, const SurfaceMesh& mesh, const WriteOptions& options = {});
void write_msh(const std::string& path, const TetMesh& mesh, const WriteOptions& options = {});
std::string format_msh(const SurfaceMesh& mesh, const WriteOptions& options = {});
std::string format_msh(const TetMesh& mesh, const WriteOptions& options = {});

/// MEDIT .mesh in text; dimension 2 gives z = 0.
SurfaceMesh read_medit_surface(const std::string& path, const ReadOptions& options = {});
SurfaceMesh parse_medit_surface(std::string_view text, const std::string& name,
                                const ReadOptions& options = {});
TetMesh read_medit_tets(const std::string& path, const ReadOptions& options = {});
TetMesh parse_medit_tets(std::string_view text, const std::string& name, const ReadOptions& options = {});
/// Reads the elements of a body from memory, see read_elements().
ElementMesh parse_medit_elements(std::string_view text, const std::string& name,
                                 const ReadOptions& options = {});
void write_medit(const std::string& path, const SurfaceMesh& mesh);
void write_medit(const std::string& path, const TetMesh& mesh);
std::string format_medit(const SurfaceMesh& mesh);
std::string format_medit(const TetMesh& mesh);

/// Legacy VTK, text and binary: POLYDATA (polygons and triangle strips) and UNSTRUCTURED_GRID of versions 2
/// to
/// 5. Written as version 3.0, surfaces as POLYDATA, tetrahedra as UNSTRUCTURED_GRID.
SurfaceMesh read_vtk_surface(const std::string& path, const ReadOptions& options = {});
SurfaceMesh parse_vtk_surface(std::string_view contents, const std::string& name,
                              const ReadOptions& options = {});
TetMesh read_vtk_tets(const std::string& path, const ReadOptions& options = {});
TetMesh parse_vtk_tets(std::string_view contents, const std::string& name, const ReadOptions& options = {});
/// Reads the elements of a body from memory, see read_elements().
ElementMesh parse_vtk_elements(std::string_view contents, const std::string& name,
                               const ReadOptions& options = {});
void write_vtk(const std::string& path, const SurfaceMesh& mesh, const WriteOptions& options = {});
void write_vtk(const std::string& path, const TetMesh& mesh, const WriteOptions& options = {});
std::string format_vtk(const SurfaceMesh& mesh, const WriteOptions& options = {});
std::string format_vtk(const TetMesh& mesh, const WriteOptions& options = {});

/// VTK's XML for unstructured grids: text, base64 in the arrays, and appended data, raw or in base64; lengths
/// of 32 and 64 bits; arrays compressed by zlib, as VTK and meshio do by default. Other compressors are
/// refused by name. Pieces are joined.
SurfaceMesh read_vtu_surface(const std::string& path, const ReadOptions& options = {});
SurfaceMesh parse_vtu_surface(std::string_view contents, const std::string& name,
                              const ReadOptions& options = {});
TetMesh read_vtu_tets(const std::string& path, const ReadOptions& options = {});
TetMesh parse_vtu_tets(std::string_view contents, const std::string& name, const ReadOptions& options = {});
/// Reads the elements of a body from memory, see read_elements().
ElementMesh parse_vtu_elements(std::string_view contents, const std::string& name,
                               const ReadOptions& options = {});
void write_vtu(const std::string& path, const SurfaceMesh& mesh, const WriteOptions& options = {});
void write_vtu(const std::string& path, const TetMesh& mesh, const WriteOptions& options = {});
std::string format_vtu(const SurfaceMesh& mesh, const WriteOptions& options = {});
std::string format_vtu(const TetMesh& mesh, const WriteOptions& options = {});

/// The two files of a tetrahedral mesh of TetGen in memory, and their names for messages.
struct TetgenFiles {
  std::string_view node;
  const std::string& node_name;
  std::string_view ele;
  const std::string& ele_name;
};

/// Reads TetGen's .node and .ele, counting from 0 or 1, with comments; attributes of nodes and markers are
/// skipped, and the first attribute of a tetrahedron is its group. Nodes of second order are put in VTK's
/// order by where they lie. Reading only. `path` is either of the two files, the other one is beside it.
TetMesh read_tetgen_tets(const std::string& path, const ReadOptions& options = {});
/// The same from memory.
TetMesh parse_tetgen_tets(const TetgenFiles& files, const ReadOptions& options = {});
/// Reads the elements of a body, see read_elements().
ElementMesh read_tetgen_elements(const std::string& path, const ReadOptions& options = {});
/// The same from memory.
ElementMesh parse_tetgen_elements(const TetgenFiles& files, const ReadOptions& options = {});

struct GlbOptions {
  /// Area-weighted normals of the vertices of the mesh, smooth across texture seams; where the triangles of a
  /// vertex leave no direction, (0, 0, 1).
  bool normals = true;
  /// The bytes of a PNG file to embed as base colour; needs texture coordinates. Empty: a plain grey surface.
  std::string base_color_png = {};
  /// How often the picture is repeated along a side of the unit square of uv, from its lower left corner; uv
  /// stay as they are (extension KHR_texture_transform, left out for 1). Positive and finite.
  double repeats = 1;
};

/// Binary glTF 2.0, one mesh. A vertex is doubled where its texture coordinates differ, v runs downwards as
/// glTF wants it, and vertices that no triangle uses are left out. Numbers are floats: a coordinate beyond
/// their range is refused. Writing only.
void write_glb(const std::string& path, const SurfaceMesh& mesh, const GlbOptions& options = {});
std::string format_glb(const SurfaceMesh& mesh, const GlbOptions& options = {});

/// One shape of an animation: places of all vertices, and the time in seconds at which they are there.
struct GlbFrame {
  double seconds = 0;
  Points3 vertices;
};

/// Returns a binary glTF 2.0 file in which the mesh runs through the frames: a morph target each (a shape
/// key, in Blender), with one animation that leads from one to the next linearly. The mesh itself is the
/// shape without any target. It has no normals: clients shade the shapes as they are. Throws Error without
/// frames, for frames of another number of vertices, for times that do not increase, and as format_glb()
/// does.
std::string format_glb_animation(const SurfaceMesh& mesh, const std::vector<GlbFrame>& frames);

}  // namespace isostretch::mesh
