#pragma once

#include <isostretch/mesh/element_mesh.hpp>
#include <isostretch/mesh/types.hpp>

#include <string>
#include <string_view>
#include <vector>

namespace isostretch::mesh {

/// The choices of a reader.
struct ReadOptions {
  /// Leaves out faces that are none (of less than three vertices, or polygons that cross themselves or have
  /// no area), and tells the log how many; otherwise they are refused.
  bool leave_out_faces = false;
  /// The end of the message about such a face: how the user has it left out.
  std::string face_advice = {};
  /// Takes texture coordinates of OBJ, PLY, OFF, VTK and VTU files, where either every face has them or none;
  /// false ignores them.
  bool read_uv = true;
  /// Makes one vertex of equal corners in STL files, which know corners only; otherwise every triangle has
  /// three vertices of its own.
  bool weld = true;
  /// The distance from the first of them up to which welding takes corners for equal; 0 takes those with the
  /// same numbers.
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

/// Reads a surface from a file in the format of its extension, in any case: .obj .off .ply .stl .msh .mesh
/// .vtk .vtu. Faces of more than three vertices are cut into triangles. Throws Error, which begins with the
/// path and the line or byte at fault, if the file cannot be opened or read.
SurfaceMesh read_surface(const std::string& path, const ReadOptions& options = {});
/// Reads a tetrahedral mesh from a file in the format of its extension: .msh .mesh .vtk .vtu .node .ele.
/// Throws Error, which begins with the path and the line or byte at fault, if the file cannot be opened or
/// read, or has other solid elements.
TetMesh read_tets(const std::string& path, const ReadOptions& options = {});

/// The encoding of a written file, for formats that have both.
enum class Encoding { text, binary };
/// The version of a written MSH file.
enum class MshVersion { v2_2, v4_0, v4_1 };

/// The choices of a writer.
struct WriteOptions {
  /// Encoding of PLY, MSH, VTK and VTU files; other formats have one encoding.
  Encoding encoding = Encoding::binary;
  MshVersion msh_version = MshVersion::v4_1;  ///< Version of MSH files.
  /// Writes base64 in every array of a binary VTU file instead of raw bytes at the end.
  bool vtu_base64 = false;
  bool vtu_compressed = false;  ///< Compresses the arrays of a binary VTU file by zlib.
};

// Writers keep every bit: shortest decimal numbers that read back the same, or binary doubles. The file
// appears complete or not at all. They throw Error when it cannot be written, when the mesh has no elements,
// or naming the vertex or element with a coordinate that is not finite or an index out of range. `format`
// functions return the contents.

/// Writes a surface in the format of the extension: .obj .off .ply .msh .mesh .vtk .vtu .glb. The file
/// appears complete or not at all. Throws Error if it cannot be written, or if the mesh has no elements, a
/// coordinate that is not finite or an index out of range.
void write_surface(const std::string& path, const SurfaceMesh& mesh, const WriteOptions& options = {});
/// Writes a tetrahedral mesh in the format of the extension: .msh .mesh .vtk .vtu. The file appears complete
/// or not at all. Throws Error if it cannot be written, or if the mesh has no elements, a coordinate that is
/// not finite or an index out of range.
void write_tets(const std::string& path, const TetMesh& mesh, const WriteOptions& options = {});

/// Reads a surface from a Wavefront OBJ file: v, vt and f, with negative indices and line continuations.
/// Normals, groups, materials, colours after a vertex and every other statement are skipped; ObjDocument
/// keeps them. Throws Error, which begins with the path and line at fault, if the file cannot be opened or
/// read.
SurfaceMesh read_obj(const std::string& path, const ReadOptions& options = {});
/// Reads a surface from the contents of a Wavefront OBJ file, as read_obj() does; `name` stands for the path
/// in messages.
SurfaceMesh parse_obj(std::string_view text, const std::string& name, const ReadOptions& options = {});
/// Writes a surface as a Wavefront OBJ file, complete or not at all, with numbers that read back bit for bit.
/// Throws Error if it cannot be written, or if the mesh has no elements, a coordinate that is not finite or
/// an index out of range.
void write_obj(const std::string& path, const SurfaceMesh& mesh);
/// Returns the contents of the file that write_obj() writes.
std::string format_obj(const SurfaceMesh& mesh);

/// Reads a surface from a text file in Object File Format, with comments; colours, normals and texture
/// coordinates of vertices and faces are skipped. Throws Error, which begins with the path and line at fault,
/// if the file cannot be opened or read.
SurfaceMesh read_off(const std::string& path, const ReadOptions& options = {});
/// Reads a surface from the contents of an OFF file, as read_off() does; `name` stands for the path in
/// messages.
SurfaceMesh parse_off(std::string_view text, const std::string& name, const ReadOptions& options = {});
/// Writes a surface as an OFF file, complete or not at all, with numbers that read back bit for bit and
/// without texture coordinates. Throws Error if it cannot be written, or if the mesh has no elements, a
/// coordinate that is not finite or an index out of range.
void write_off(const std::string& path, const SurfaceMesh& mesh);
/// Returns the contents of the file that write_off() writes.
std::string format_off(const SurfaceMesh& mesh);

/// Reads a surface from a Stanford PLY file in text or in either byte order: x, y, z of vertices, and faces
/// from the list vertex_indices or vertex_index, in any types; other elements and properties are skipped.
/// Texture coordinates are properties of vertices (s and t, u and v, texture_u and texture_v, texture_s and
/// texture_t) or, before these, the list texcoord of faces. Throws Error, which begins with the path and the
/// line or byte at fault, if the file cannot be opened or read.
SurfaceMesh read_ply(const std::string& path, const ReadOptions& options = {});
/// Reads a surface from the contents of a PLY file, as read_ply() does; `name` stands for the path in
/// messages.
SurfaceMesh parse_ply(std::string_view contents, const std::string& name, const ReadOptions& options = {});
/// Writes a surface as a PLY file with doubles, complete or not at all; binary in little endian. Texture
/// coordinates are properties s and t of vertices, or the list texcoord of faces where a vertex has several.
/// Throws Error if it cannot be written, or if the mesh has no elements, a coordinate that is not finite or
/// an index out of range.
void write_ply(const std::string& path, const SurfaceMesh& mesh, const WriteOptions& options = {});
/// Returns the contents of the file that write_ply() writes.
std::string format_ply(const SurfaceMesh& mesh, const WriteOptions& options = {});

/// Reads a surface from an STL file, binary if its length is what its number of triangles makes, and text if
/// it begins with solid; normals, colours and names are skipped. What follows the triangles that a binary
/// file counts is not read, and the log told. Throws Error, which begins with the path and the line or byte
/// at fault, if the file cannot be opened or read.
SurfaceMesh read_stl(const std::string& path, const ReadOptions& options = {});
/// Reads a surface from the contents of an STL file, as read_stl() does; `name` stands for the path in
/// messages.
SurfaceMesh parse_stl(std::string_view contents, const std::string& name, const ReadOptions& options = {});

// The formats below hold elements of many shapes. Reading a surface takes triangles, quadrangles and
// polygons, and refuses faces of higher order. Reading tetrahedra takes those of four nodes, and refuses a
// file with other solid elements, naming how many of which shape. Reading elements takes those of the highest
// dimension in the file, which must be of one shape: triangles and tetrahedra, linear or of second order,
// quadrangles or hexahedra. Points, lines, the faces of a solid, entities, partitions and data are skipped.

/// Reads the elements of a body, and the groups they are in, from a file in the format of its extension: .msh
/// .mesh .vtk .vtu .node .ele, and of surfaces .obj .off .ply .stl, whose faces become triangles. Takes the
/// elements of the highest dimension in the file, which must be of one shape: triangles and tetrahedra,
/// linear or of second order, quadrangles or hexahedra. Throws Error, which begins with the path and the line
/// or byte at fault, if the file cannot be opened or read.
ElementMesh read_elements(const std::string& path, const ReadOptions& options = {});

/// Reads the triangles, quadrangles and polygons of a Gmsh MSH file, versions 2.0 to 2.2, 4.0 and 4.1, text
/// and binary of either byte order. Node tags may have gaps; vertices are in the order of the file. An
/// element that is there several times under one number, or in version 2 once for each of its physical
/// groups, is one element; different ones under one number are refused. Throws Error, which begins with the
/// path and the line or byte at fault, if the file cannot be opened or read.
SurfaceMesh read_msh_surface(const std::string& path, const ReadOptions& options = {});
/// Reads a surface from the contents of a Gmsh MSH file, as read_msh_surface() does; `name` stands for the
/// path in messages.
SurfaceMesh parse_msh_surface(std::string_view contents, const std::string& name,
                              const ReadOptions& options = {});
/// Reads the tetrahedra of four nodes of a Gmsh MSH file, versions 2.0 to 2.2, 4.0 and 4.1, text and binary
/// of either byte order. Throws Error, which begins with the path and the line or byte at fault, if the file
/// cannot be opened or read, or has other solid elements.
TetMesh read_msh_tets(const std::string& path, const ReadOptions& options = {});
/// Reads tetrahedra from the contents of a Gmsh MSH file, as read_msh_tets() does; `name` stands for the path
/// in messages.
TetMesh parse_msh_tets(std::string_view contents, const std::string& name, const ReadOptions& options = {});
/// Reads the elements of a body from the contents of a Gmsh MSH file, as read_elements() does; `name` stands
/// for the path in messages.
ElementMesh parse_msh_elements(std::string_view contents, const std::string& name,
                               const ReadOptions& options = {});
/// Writes a surface as a Gmsh MSH file, complete or not at all, without texture coordinates. Throws Error if
/// it cannot be written, or if the mesh has no elements, a coordinate that is not finite or an index out of
/// range.
void write_msh(const std::string& path, const SurfaceMesh& mesh, const WriteOptions& options = {});
/// Writes a tetrahedral mesh as a Gmsh MSH file, complete or not at all. Throws Error if it cannot be
/// written, or if the mesh has no elements, a coordinate that is not finite or an index out of range.
void write_msh(const std::string& path, const TetMesh& mesh, const WriteOptions& options = {});
/// Returns the contents of the file that write_msh() writes for a surface.
std::string format_msh(const SurfaceMesh& mesh, const WriteOptions& options = {});
/// Returns the contents of the file that write_msh() writes for a tetrahedral mesh.
std::string format_msh(const TetMesh& mesh, const WriteOptions& options = {});

/// Reads the triangles and quadrangles of a MEDIT .mesh file in text; dimension 2 gives z = 0. Throws Error,
/// which begins with the path and line at fault, if the file cannot be opened or read.
SurfaceMesh read_medit_surface(const std::string& path, const ReadOptions& options = {});
/// Reads a surface from the contents of a MEDIT file, as read_medit_surface() does; `name` stands for the
/// path in messages.
SurfaceMesh parse_medit_surface(std::string_view text, const std::string& name,
                                const ReadOptions& options = {});
/// Reads the tetrahedra of a MEDIT .mesh file in text. Throws Error, which begins with the path and line at
/// fault, if the file cannot be opened or read, or has other solid elements.
TetMesh read_medit_tets(const std::string& path, const ReadOptions& options = {});
/// Reads tetrahedra from the contents of a MEDIT file, as read_medit_tets() does; `name` stands for the path
/// in messages.
TetMesh parse_medit_tets(std::string_view text, const std::string& name, const ReadOptions& options = {});
/// Reads the elements of a body from the contents of a MEDIT file, as read_elements() does; `name` stands for
/// the path in messages.
ElementMesh parse_medit_elements(std::string_view text, const std::string& name,
                                 const ReadOptions& options = {});
/// Writes a surface as a MEDIT .mesh file, complete or not at all, with numbers that read back bit for bit
/// and without texture coordinates. Throws Error if it cannot be written, or if the mesh has no elements, a
/// coordinate that is not finite or an index out of range.
void write_medit(const std::string& path, const SurfaceMesh& mesh);
/// Writes a tetrahedral mesh as a MEDIT .mesh file, complete or not at all, with numbers that read back bit
/// for bit. Throws Error if it cannot be written, or if the mesh has no elements, a coordinate that is not
/// finite or an index out of range.
void write_medit(const std::string& path, const TetMesh& mesh);
/// Returns the contents of the file that write_medit() writes for a surface.
std::string format_medit(const SurfaceMesh& mesh);
/// Returns the contents of the file that write_medit() writes for a tetrahedral mesh.
std::string format_medit(const TetMesh& mesh);

/// Reads the faces of a legacy VTK file, text or binary: POLYDATA (polygons and triangle strips) and
/// UNSTRUCTURED_GRID of versions 2 to 5. Throws Error, which begins with the path and the line or byte at
/// fault, if the file cannot be opened or read.
SurfaceMesh read_vtk_surface(const std::string& path, const ReadOptions& options = {});
/// Reads a surface from the contents of a legacy VTK file, as read_vtk_surface() does; `name` stands for the
/// path in messages.
SurfaceMesh parse_vtk_surface(std::string_view contents, const std::string& name,
                              const ReadOptions& options = {});
/// Reads the tetrahedra of four nodes of a legacy VTK file, UNSTRUCTURED_GRID of versions 2 to 5, text or
/// binary. Throws Error, which begins with the path and the line or byte at fault, if the file cannot be
/// opened or read, or has other solid elements.
TetMesh read_vtk_tets(const std::string& path, const ReadOptions& options = {});
/// Reads tetrahedra from the contents of a legacy VTK file, as read_vtk_tets() does; `name` stands for the
/// path in messages.
TetMesh parse_vtk_tets(std::string_view contents, const std::string& name, const ReadOptions& options = {});
/// Reads the elements of a body from the contents of a legacy VTK file, as read_elements() does; `name`
/// stands for the path in messages.
ElementMesh parse_vtk_elements(std::string_view contents, const std::string& name,
                               const ReadOptions& options = {});
/// Writes a surface as POLYDATA in a legacy VTK file of version 3.0, complete or not at all, without texture
/// coordinates. Throws Error if it cannot be written, or if the mesh has no elements, a coordinate that is
/// not finite or an index out of range.
void write_vtk(const std::string& path, const SurfaceMesh& mesh, const WriteOptions& options = {});
/// Writes a tetrahedral mesh as UNSTRUCTURED_GRID in a legacy VTK file of version 3.0, complete or not at
/// all. Throws Error if it cannot be written, or if the mesh has no elements, a coordinate that is not finite
/// or an index out of range.
void write_vtk(const std::string& path, const TetMesh& mesh, const WriteOptions& options = {});
/// Returns the contents of the file that write_vtk() writes for a surface.
std::string format_vtk(const SurfaceMesh& mesh, const WriteOptions& options = {});
/// Returns the contents of the file that write_vtk() writes for a tetrahedral mesh.
std::string format_vtk(const TetMesh& mesh, const WriteOptions& options = {});

/// Reads the faces of a VTU file, VTK's XML for unstructured grids: text, base64 in the arrays, and appended
/// data, raw or in base64; lengths of 32 and 64 bits; arrays compressed by zlib, as VTK and meshio do by
/// default. Other compressors are refused by name. Pieces are joined. Throws Error, which begins with the
/// path and the line or byte at fault, if the file cannot be opened or read.
SurfaceMesh read_vtu_surface(const std::string& path, const ReadOptions& options = {});
/// Reads a surface from the contents of a VTU file, as read_vtu_surface() does; `name` stands for the path in
/// messages.
SurfaceMesh parse_vtu_surface(std::string_view contents, const std::string& name,
                              const ReadOptions& options = {});
/// Reads the tetrahedra of four nodes of a VTU file, in the encodings that read_vtu_surface() knows. Throws
/// Error, which begins with the path and the line or byte at fault, if the file cannot be opened or read, or
/// has other solid elements.
TetMesh read_vtu_tets(const std::string& path, const ReadOptions& options = {});
/// Reads tetrahedra from the contents of a VTU file, as read_vtu_tets() does; `name` stands for the path in
/// messages.
TetMesh parse_vtu_tets(std::string_view contents, const std::string& name, const ReadOptions& options = {});
/// Reads the elements of a body from the contents of a VTU file, as read_elements() does; `name` stands for
/// the path in messages.
ElementMesh parse_vtu_elements(std::string_view contents, const std::string& name,
                               const ReadOptions& options = {});
/// Writes a surface as a VTU file, complete or not at all, without texture coordinates. Throws Error if it
/// cannot be written, or if the mesh has no elements, a coordinate that is not finite or an index out of
/// range.
void write_vtu(const std::string& path, const SurfaceMesh& mesh, const WriteOptions& options = {});
/// Writes a tetrahedral mesh as a VTU file, complete or not at all. Throws Error if it cannot be written, or
/// if the mesh has no elements, a coordinate that is not finite or an index out of range.
void write_vtu(const std::string& path, const TetMesh& mesh, const WriteOptions& options = {});
/// Returns the contents of the file that write_vtu() writes for a surface.
std::string format_vtu(const SurfaceMesh& mesh, const WriteOptions& options = {});
/// Returns the contents of the file that write_vtu() writes for a tetrahedral mesh.
std::string format_vtu(const TetMesh& mesh, const WriteOptions& options = {});

/// The contents of the two files of a tetrahedral mesh of TetGen, and their names for messages.
struct TetgenFiles {
  std::string_view node;         ///< Contents of the .node file.
  const std::string& node_name;  ///< Name of the .node file.
  std::string_view ele;          ///< Contents of the .ele file.
  const std::string& ele_name;   ///< Name of the .ele file.
};

/// Reads the tetrahedra of four nodes of TetGen's .node and .ele files, counting from 0 or 1, with comments;
/// attributes of nodes and markers are skipped. `path` is either of the two files, the other one is beside
/// it. Throws Error, which begins with the path and line at fault, if a file cannot be opened or read.
TetMesh read_tetgen_tets(const std::string& path, const ReadOptions& options = {});
/// Reads tetrahedra from the contents of TetGen's files, as read_tetgen_tets() does.
TetMesh parse_tetgen_tets(const TetgenFiles& files, const ReadOptions& options = {});
/// Reads the elements of a body from TetGen's .node and .ele files; the first attribute of a tetrahedron is
/// its group. Nodes of second order are put in VTK's order by where they lie. `path` is either of the two
/// files, the other one is beside it. Throws Error, which begins with the path and line at fault, if a file
/// cannot be opened or read.
ElementMesh read_tetgen_elements(const std::string& path, const ReadOptions& options = {});
/// Reads the elements of a body from the contents of TetGen's files, as read_tetgen_elements() does.
ElementMesh parse_tetgen_elements(const TetgenFiles& files, const ReadOptions& options = {});

/// The choices of the writers of binary glTF files.
struct GlbOptions {
  /// Writes area-weighted normals of the vertices of the mesh, smooth across texture seams; where the
  /// triangles of a vertex leave no direction, (0, 0, 1).
  bool normals = true;
  /// The bytes of a PNG file to embed as base colour, which needs texture coordinates. Empty gives a plain
  /// grey surface.
  std::string base_color_png = {};
  /// The number of times that the picture is repeated along a side of the unit square of uv, from its lower
  /// left corner; uv stay as they are (extension KHR_texture_transform, left out for 1). Positive and finite.
  double repeats = 1;
};

/// Writes a surface as a binary glTF 2.0 file with one mesh. A vertex is doubled where its texture
/// coordinates differ, v runs downwards as glTF wants it, and vertices that no triangle uses are left out.
/// Numbers are floats. Throws Error if the file cannot be written, or if the mesh has no triangles, a
/// coordinate that is not finite or beyond the range of floats, or an index out of range.
void write_glb(const std::string& path, const SurfaceMesh& mesh, const GlbOptions& options = {});
/// Returns the contents of the file that write_glb() writes.
std::string format_glb(const SurfaceMesh& mesh, const GlbOptions& options = {});

/// A shape of an animation, and the time at which it is reached.
struct GlbFrame {
  double seconds = 0;  ///< In seconds.
  Points3 vertices;    ///< V x 3, the positions of all vertices.
};

/// Returns a binary glTF 2.0 file in which the mesh runs through the frames: a morph target each (a shape
/// key, in Blender), with one animation that leads from one to the next linearly. The mesh itself is the
/// shape without any target. It has no normals: clients shade the shapes as they are. Throws Error without
/// frames, for frames of another number of vertices, for times that do not increase, and as format_glb()
/// does.
std::string format_glb_animation(const SurfaceMesh& mesh, const std::vector<GlbFrame>& frames);

}  // namespace isostretch::mesh
