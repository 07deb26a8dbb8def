#include "file.hpp"
#include "output.hpp"
#include "vtk_cells.hpp"
#include "writable.hpp"
#include "zlib.hpp"

#include <isostretch/core/base64.hpp>
#include <isostretch/core/error.hpp>
#include <isostretch/mesh_io/fields.hpp>

#include <cstdint>
#include <string>
#include <string_view>

namespace isostretch::mesh {
namespace {

// As the value of an attribute.
std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c == '&')
      result += "&amp;";
    else if (c == '<')
      result += "&lt;";
    else if (c == '"')
      result += "&quot;";
    else
      result += c;
  }
  return result;
}

int vtk_type(Shape shape) {
  switch (shape) {
    case Shape::triangle:
      return vtk_triangle;
    case Shape::quadratic_triangle:
      return vtk_quadratic_triangle;
    case Shape::quad:
      return vtk_quad;
    case Shape::tet:
      return vtk_tet;
    case Shape::quadratic_tet:
      return vtk_quadratic_tet;
    case Shape::hex:
      break;
  }
  return vtk_hex;
}

void require_fits(const std::vector<MeshField>& fields, Eigen::Index count, const std::string& what) {
  for (const MeshField& field : fields)
    if (field.components < 1 ||
        static_cast<Eigen::Index>(field.values.size()) != count * Eigen::Index{field.components})
      throw Error("field '" + field.name + "': " + std::to_string(field.values.size()) +
                  " numbers, and there are " + std::to_string(count) + " " + what + " with " +
                  std::to_string(field.components) + " each");
}

// A header_type of UInt64 in front of every binary array.
class VtuWriter {
 public:
  VtuWriter(const WriteOptions& options)
      : binary_(options.encoding == Encoding::binary),
        base64_(options.vtu_base64),
        compressed_(binary_ && options.vtu_compressed) {}

  using Fields = std::vector<MeshField>;

  template <class Elements>
  std::string write(const Points3& vertices, const Elements& elements, int type,
                    const Fields& at_vertices = {}, const Fields& at_elements = {}) {
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
    out_ += "</Cells>\n";
    write_fields("PointData", at_vertices);
    write_fields("CellData", at_elements);
    out_ += "</Piece>\n</UnstructuredGrid>\n";
    if (!appended_.empty()) out_ += "<AppendedData encoding=\"raw\">\n_" + appended_ + "\n</AppendedData>\n";
    out_ += "</VTKFile>\n";
    return std::move(out_);
  }

 private:
  void start(Eigen::Index points, Eigen::Index cells) {
    out_ =
        "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" "
        "byte_order=\"LittleEndian\" "
        "header_type=\"UInt64\"" +
        std::string(compressed_ ? " compressor=\"vtkZLibDataCompressor\"" : "") +
        ">\n<UnstructuredGrid>\n<Piece NumberOfPoints=\"" + std::to_string(points) + "\" NumberOfCells=\"" +
        std::to_string(cells) + "\">\n";
  }

  void write_fields(const std::string& kind, const Fields& fields) {
    if (fields.empty()) return;
    out_.append("<").append(kind).append(">\n");
    for (const MeshField& field : fields)
      array("Float64", escaped(field.name), " NumberOfComponents=\"" + std::to_string(field.components) + '"',
            static_cast<Eigen::Index>(field.values.size()),
            [&](Eigen::Index i) { return field.values[static_cast<std::size_t>(i)]; });
    out_.append("</").append(kind).append(">\n");
  }

  template <class Value>
  void array(const char* type, const std::string& name, const std::string& attributes, Eigen::Index count,
             const Value& value) {
    out_ += std::string("<DataArray type=\"") + type + "\" Name=\"" + name + '"' + attributes;
    if (binary_ && !base64_) {
      out_ += " format=\"appended\" offset=\"" + std::to_string(appended_.size()) + "\"/>\n";
      const Encoded array = encoded(count, value);
      appended_ += array.header + array.data;
      return;
    }
    out_ += binary_ ? " format=\"binary\">\n" : " format=\"ascii\">\n";
    if (binary_)
      append_encoded(count, value);
    else
      append_numbers(count, value);
    out_ += "</DataArray>\n";
  }

  struct Encoded {
    std::string header, data;
  };

  template <class Value>
  Encoded encoded(Eigen::Index count, const Value& value) const {
    Encoded array;
    for (Eigen::Index i = 0; i < count; ++i) append_bytes(array.data, value(i));
    if (compressed_) return compressed(array.data);
    append_bytes(array.header, std::uint64_t{array.data.size()});
    return array;
  }

  // In blocks as large as VTK makes them.
  static Encoded compressed(std::string_view bytes) {
    constexpr std::size_t block = 32768;
    Encoded array;
    std::string sizes;
    for (std::size_t i = 0; i < bytes.size(); i += block) {
      const std::string stream = deflated(bytes.substr(i, block));
      append_bytes(sizes, std::uint64_t{stream.size()});
      array.data += stream;
    }
    append_bytes(array.header, std::uint64_t{sizes.size() / sizeof(std::uint64_t)});
    append_bytes(array.header, std::uint64_t{block});
    append_bytes(array.header, std::uint64_t{bytes.size() % block});
    array.header += sizes;
    return array;
  }

  template <class Value>
  void append_encoded(Eigen::Index count, const Value& value) {
    const Encoded array = encoded(count, value);
    if (compressed_) append_base64(out_, array.header);
    append_base64(out_, compressed_ ? array.data : array.header + array.data);
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
  bool compressed_;
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

std::string format_vtu(const ElementMesh& mesh, const std::vector<MeshField>& at_vertices,
                       const std::vector<MeshField>& at_elements, const WriteOptions& options) {
  require_writable(mesh);
  require_fits(at_vertices, mesh.vertices.rows(), "vertices");
  require_fits(at_elements, mesh.elements.rows(), "elements");
  return VtuWriter(options).write(mesh.vertices, mesh.elements, vtk_type(mesh.shape), at_vertices,
                                  at_elements);
}

void write_vtu(const std::string& path, const ElementMesh& mesh, const std::vector<MeshField>& at_vertices,
               const std::vector<MeshField>& at_elements, const WriteOptions& options) {
  write_file(path, format_vtu(mesh, at_vertices, at_elements, options));
}

void write_vtu(const std::string& path, const SurfaceMesh& mesh, const WriteOptions& options) {
  write_file(path, format_vtu(mesh, options));
}

void write_vtu(const std::string& path, const TetMesh& mesh, const WriteOptions& options) {
  write_file(path, format_vtu(mesh, options));
}

}  // namespace isostretch::mesh
