#include "common/vtu.hpp"

#include <cstdint>
#include <cstring>

namespace isostretch::app {
namespace {

std::uint8_t vtk_type(mesh::Shape shape) {
  switch (shape) {
    case mesh::Shape::triangle:
      return 5;
    case mesh::Shape::quadratic_triangle:
      return 22;
    case mesh::Shape::quad:
      return 9;
    case mesh::Shape::tet:
      return 10;
    case mesh::Shape::quadratic_tet:
      return 24;
    case mesh::Shape::hex:
      break;
  }
  return 12;
}

// Arrays stand in the header by name and offset, and their bytes, after a length, at the end.
class Arrays {
 public:
  template <class Number>
  std::string add(const char* type, const std::string& name, const Number* data, std::size_t count,
                  int components = 1) {
    const std::string entry = std::string("<DataArray type=\"") + type + "\" Name=\"" + name +
                              "\" NumberOfComponents=\"" + std::to_string(components) +
                              "\" format=\"appended\" offset=\"" + std::to_string(bytes_.size()) + "\"/>\n";
    const std::uint64_t length = count * sizeof(Number);
    append(&length, sizeof length);
    append(data, length);
    return entry;
  }
  const std::string& bytes() const { return bytes_; }

 private:
  void append(const void* data, std::size_t length) {
    if (length > 0) bytes_.append(static_cast<const char*>(data), length);
  }
  std::string bytes_;
};

}  // namespace

std::string vtu_text(const SolidModel& body, const mesh::Points3& flat, const std::vector<CellField>& fields,
                     const std::vector<NodeField>& node_fields) {
  const auto cells = static_cast<std::size_t>(body.elements.element_count());
  std::vector<std::int64_t> offsets(cells);
  for (std::size_t i = 0; i < cells; ++i)
    offsets[i] = static_cast<std::int64_t>(i + 1) * body.elements.nodes_per_element;
  const std::vector<std::uint8_t> types(cells, vtk_type(body.shape));
  const mesh::Points3 points = body.placed(flat), displacement = points - body.placed(body.nodes);
  const auto numbers = static_cast<std::size_t>(points.size());

  Arrays arrays;
  std::string text =
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" "
      "byte_order=\"LittleEndian\" header_type=\"UInt64\">\n<UnstructuredGrid>\n<Piece NumberOfPoints=\"" +
      std::to_string(points.rows()) + "\" NumberOfCells=\"" + std::to_string(cells) + "\">\n";
  text += "<Points>\n" + arrays.add("Float64", "Points", points.data(), numbers, 3) + "</Points>\n<Cells>\n";
  text += arrays.add("Int32", "connectivity", body.elements.nodes.data(), body.elements.nodes.size());
  text += arrays.add("Int64", "offsets", offsets.data(), cells);
  text += arrays.add("UInt8", "types", types.data(), cells) + "</Cells>\n<PointData>\n";
  text += arrays.add("Float64", "displacement", displacement.data(), numbers, 3);
  for (const NodeField& field : node_fields)
    text += arrays.add("Float64", field.name, field.values.data(), field.values.size());
  text += "</PointData>\n<CellData>\n";
  for (const CellField& field : fields) text += arrays.add("Float64", field.name, field.values.data(), cells);
  return text + "</CellData>\n</Piece>\n</UnstructuredGrid>\n<AppendedData encoding=\"raw\">\n_" +
         arrays.bytes() + "\n</AppendedData>\n</VTKFile>\n";
}

}  // namespace isostretch::app
