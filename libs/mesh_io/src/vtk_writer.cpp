#include "file.hpp"
#include "output.hpp"
#include "vtk_cells.hpp"
#include "writable.hpp"

#include <isostretch/mesh_io/io.hpp>

#include <cstdint>

namespace isostretch::mesh {
namespace {

class VtkWriter {
 public:
  VtkWriter(const char* dataset, Encoding encoding) : binary_(encoding == Encoding::binary) {
    out_ = "# vtk DataFile Version 3.0\nisostretch\n";
    out_ += binary_ ? "BINARY\n" : "ASCII\n";
    out_ += std::string("DATASET ") + dataset + '\n';
  }

  void points(const Points3& points) {
    out_ += "POINTS " + std::to_string(points.rows()) + " double\n";
    for (Eigen::Index i = 0; i < points.rows(); ++i) row(points, i);
    end();
  }

  // The number of points in front of those of every cell.
  template <class Elements>
  void cells(const char* keyword, const Elements& elements) {
    constexpr std::int32_t corners = Elements::ColsAtCompileTime;
    out_ += std::string(keyword) + ' ' + std::to_string(elements.rows()) + ' ' +
            std::to_string((corners + 1) * elements.rows()) + '\n';
    for (Eigen::Index e = 0; e < elements.rows(); ++e) {
      number(corners);
      row(elements, e);
    }
    end();
  }

  void types(std::int32_t type, Eigen::Index count) {
    out_ += "CELL_TYPES " + std::to_string(count) + '\n';
    for (Eigen::Index e = 0; e < count; ++e) {
      number(type);
      if (!binary_) out_ += '\n';
    }
    end();
  }

  std::string& text() { return out_; }

 private:
  void number(std::int32_t value) {
    if (binary_)
      append_bytes(out_, value, std::endian::big);
    else
      append(out_, value);
  }

  template <class Matrix>
  void row(const Matrix& matrix, Eigen::Index i) {
    if (binary_) {
      append_row_bytes(out_, matrix, i, std::endian::big);
    } else {
      append_row(out_, matrix, i);
      out_ += '\n';
    }
  }

  void end() {
    if (binary_) out_ += '\n';
  }

  bool binary_;
  std::string out_;
};

}  // namespace

std::string format_vtk(const SurfaceMesh& mesh, const WriteOptions& options) {
  require_writable(mesh);
  VtkWriter writer("POLYDATA", options.encoding);
  writer.points(mesh.vertices);
  writer.cells("POLYGONS", mesh.triangles);
  return std::move(writer.text());
}

std::string format_vtk(const TetMesh& mesh, const WriteOptions& options) {
  require_writable(mesh);
  VtkWriter writer("UNSTRUCTURED_GRID", options.encoding);
  writer.points(mesh.vertices);
  writer.cells("CELLS", mesh.tets);
  writer.types(vtk_tet, mesh.tets.rows());
  return std::move(writer.text());
}

void write_vtk(const std::string& path, const SurfaceMesh& mesh, const WriteOptions& options) {
  write_file(path, format_vtk(mesh, options));
}

void write_vtk(const std::string& path, const TetMesh& mesh, const WriteOptions& options) {
  write_file(path, format_vtk(mesh, options));
}

}  // namespace isostretch::mesh
