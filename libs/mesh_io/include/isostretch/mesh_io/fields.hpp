#pragma once

#include <isostretch/mesh/element_mesh.hpp>
#include <isostretch/mesh_io/io.hpp>

#include <string>
#include <vector>

namespace isostretch::mesh {

/// Numbers at every vertex or every element of a mesh, such as a displacement or a stress.
struct MeshField {
  std::string name;            ///< Under which programs show the field.
  std::vector<double> values;  ///< `components` numbers for each vertex or element, in their order.
  int components = 1;          ///< 1 for a scalar, 3 for a vector in space.
};

/// Returns a mesh of elements of any shape with fields as VTK's unstructured grid in XML. By default numbers
/// are raw doubles at the end of the file. Throws Error naming what does not fit: elements or a field whose
/// size is not that of the mesh, indices out of range, vertices that are not finite.
std::string format_vtu(const ElementMesh& mesh, const std::vector<MeshField>& at_vertices,
                       const std::vector<MeshField>& at_elements, const WriteOptions& options = {});

/// Writes a mesh with fields into a file, see format_vtu(). Throws Error naming the file where it cannot be
/// written.
void write_vtu(const std::string& path, const ElementMesh& mesh, const std::vector<MeshField>& at_vertices,
               const std::vector<MeshField>& at_elements, const WriteOptions& options = {});

}  // namespace isostretch::mesh
