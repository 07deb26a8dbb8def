#include "base64.hpp"
#include "file.hpp"
#include "output.hpp"
#include "vtk_cells.hpp"
#include "writable.hpp"

#include <isostretch/mesh/io.hpp>

#include <cstdint>

namespace isostretch::mesh {
namespace {

// A header_type of UInt64 in front of every binary array.
class VtuWriter {
 public:
  VtuWriter(const WriteOptions& options)
      : binary_(options.encoding == Encoding::binary), base64_(options.vtu_base64) {}

  template <class Elements>
  std::string write(const Points3& vertices, const Elements& elements, int type) {
    const Eigen::Index corners = elements.cols(), cells = elements.rows();
    start(vertices.rows(), cells);
    out_ += "<Points>\n";
    array("Float64", "Points", " NumberOfComponents=\"3\"", vertices.size(),
          [&](Eigen::Index i) { return vertices.data()[i]; });
    out_ += "</Points>\n<Cells>\n";
    array("Int32", "connectivity", "", elements.size(),
          [&](Eigen::Index i) { return std::int32_t{elements.data()[i]}; });
    array("Int64", "offsets", "", cells, [&](Eigen::Index i) { return std::int64_t{corners * (i + 1)}; });
    array("UInt8", "types", "", cells, [&](Eigen::Index) { return static_cast<std::uint8_t>(type); });
    out_ += "</Cells>\n</Piece>\n</UnstructuredGrid>\n";
    if (!appended_.empty()) out_ += "<AppendedData encoding=\"raw\">\n_" + appended_ + "\n</AppendedData>\n";
    out_ += "</VTKFile>\n";
    return std::move(out_);
  }

 private:
  void start(Eigen::Index points, Eigen::Index cells) {
    out_ =
        "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" "
        "byte_order=\"LittleEndian\" "
        "header_type=\"UInt64\">\n<UnstructuredGrid>\n<Piece NumberOfPoints=\"" +
        std::to_string(points) + "\" NumberOfCells=\"" + std::to_string(cells) + "\">\n";
  }

  template <class Value>
  void array(const char* type, const char* name, const char* attributes, Eigen::Index count,
             const Value& value) {
    out_ += std::string("<DataArray type=\"") + type + "\" Name=\"" + name + '"' + attributes;
    if (binary_ && !base64_) {
      out_ += " format=\"appended\" offset=\"" + std::to_string(appended_.size()) + "\"/>\n";
      append_array(appended_, count, value);
      return;
    }
    out_ += binary_ ? " format=\"binary\">\n" : " format=\"ascii\">\n";
    if (binary_)
      append_encoded(count, value);
    else
      append_numbers(count, value);
    out_ += "</DataArray>\n";
  }

  template <class Value>
  static void append_array(std::string& bytes, Eigen::Index count, const Value& value) {
    append_bytes(bytes, static_cast<std::uint64_t>(count) * sizeof(value(0)));
    for (Eigen::Index i = 0; i < count; ++i) append_bytes(bytes, value(i));
  }

  template <class Value>
  void append_encoded(Eigen::Index count, const Value& value) {
    std::string bytes;
    append_array(bytes, count, value);
    append_base64(out_, bytes);
    out_ += '\n';
  }

  // Twelve a line: rows of points, triangles and tetrahedra stay whole.
  template <class Value>
  void append_numbers(Eigen::Index count, const Value& value) {
    for (Eigen::Index i = 0; i < count; ++i) {
      append(out_, value(i));
      out_ += i % 12 == 11 || i + 1 == count ? '\n' : ' ';
    }
  }

  bool binary_;
  bool base64_;
  std::string out_;
  std::string appended_;
};

}  // namespace

std::string format_vtu(const SurfaceMesh& mesh, const WriteOptions& options) {
  require_writable(mesh);
  return VtuWriter(options).write(mesh.vertices, mesh.triangles, vtk_triangle);
}

std::string format_vtu(const TetMesh& mesh, const WriteOptions& options) {
  require_writable(mesh);
  return VtuWriter(options).write(mesh.vertices, mesh.tets, vtk_tet);
}

void write_vtu(const std::string& path, const SurfaceMesh& mesh, const WriteOptions& options) {
  write_file(path, format_vtu(mesh, options));
}

void write_vtu(const std::string& path, const TetMesh& mesh, const WriteOptions& options) {
  write_file(path, format_vtu(mesh, options));
}

}  // namespace isostretch::mesh
