#pragma once

#include <isostretch/mesh/element_mesh.hpp>
#include <isostretch/mesh_io/io.hpp>

#include <functional>
#include <string>

namespace isostretch::mesh {

/// A file format: what it reads and writes. Functions that are empty are what it does not hold. Readers throw
/// Error that begins with the path; writers make the file appear complete or not at all.
struct Format {
  std::string extension;  ///< In lower case with its dot, such as ".off".
  /// Reads a surface.
  std::function<SurfaceMesh(const std::string& path, const ReadOptions&)> read_surface = {};
  /// Reads tetrahedra.
  std::function<TetMesh(const std::string& path, const ReadOptions&)> read_tets = {};
  /// Reads the elements of a body; where it is empty, the triangles of read_surface are taken.
  std::function<ElementMesh(const std::string& path, const ReadOptions&)> read_elements = {};
  /// Writes a surface.
  std::function<void(const std::string& path, const SurfaceMesh&, const WriteOptions&)> write_surface = {};
  /// Writes tetrahedra.
  std::function<void(const std::string& path, const TetMesh&, const WriteOptions&)> write_tets = {};
};

/// Adds a format to those that read_surface(), read_tets(), read_elements(), write_surface() and write_tets()
/// know by the extension of a file. May be called while other threads read. Throws Error for an extension
/// that is none or taken, and for a format without any function.
void register_format(Format format);

}  // namespace isostretch::mesh
