#include "characters.hpp"
#include "file.hpp"
#include "number.hpp"
#include "vtk_cells.hpp"
#include "vtu_arrays.hpp"

#include <isostretch/mesh_io/io.hpp>

#include <charconv>
#include <utility>

namespace isostretch::mesh {
namespace {

struct Piece {
  std::size_t start = 0;  // of its tag
  std::int64_t point_count = 0;
  std::int64_t cell_count = 0;
  VtuArray points, connectivity, offsets, types, uv;
};

// First the tags, which say where the arrays are; then the arrays of one piece after the other.
class VtuReader {
 public:
  VtuReader(std::string_view contents, const std::string& name, Wanted wanted, const ReadOptions& options)
      : contents_(contents),
        xml_(contents, name),
        arrays_(contents, name),
        elements_(wanted, options),
        wants_uv_(wanted == Wanted::surface && options.read_uv) {}

  MixedMesh read() {
    XmlTag tag;
    while (!appended_seen_ && xml_.next(tag))
      if (tag.kind != XmlTag::Kind::close) enter(tag);
    if (!file_seen_) fail(0, "not a VTK XML file: it has no VTKFile element");
    for (const Piece& piece : pieces_) add(piece);
    return {std::move(vertices_), std::move(elements_), xml_.place(contents_.size()), std::move(uv_)};
  }

 private:
  [[noreturn]] void fail(std::size_t position, const std::string& what) const {
    xml_.place(position).fail(what);
  }

  void enter(const XmlTag& tag) {
    if (!file_seen_ && tag.name != "VTKFile") fail(tag.start, "not a VTK XML file: VTKFile expected");
    if (tag.name == "VTKFile")
      file(tag);
    else if (tag.name == "Piece")
      piece(tag);
    else if (tag.name == "PointData")
      uv_name_ = tag.attribute("TCoords");
    else if (tag.name == "DataArray")
      array(tag);
    else if (tag.name == "AppendedData")
      appended(tag);
  }

  void file(const XmlTag& tag) {
    file_seen_ = true;
    if (tag.attribute("type") != "UnstructuredGrid")
      fail(tag.start, "file of type " + quoted(tag.attribute("type")) + ", not UnstructuredGrid");
    VtuCoding coding;
    const std::string_view order = tag.attribute("byte_order"), header = tag.attribute("header_type");
    if (!order.empty() && order != "LittleEndian" && order != "BigEndian")
      fail(tag.start, "unknown byte_order " + quoted(order));
    if (!header.empty() && header != "UInt32" && header != "UInt64")
      fail(tag.start, "unknown header_type " + quoted(header));
    coding.has_byte_order = !order.empty();
    coding.big_endian = order == "BigEndian";
    coding.compressor = tag.attribute("compressor");
    coding.header = header == "UInt64" ? Scalar::uint64 : Scalar::uint32;
    arrays_.set_coding(coding);
  }

  void piece(const XmlTag& tag) {
    Piece piece;
    piece.start = tag.start;
    piece.point_count = number(tag, "NumberOfPoints");
    piece.cell_count = number(tag, "NumberOfCells");
    pieces_.push_back(piece);
  }

  std::int64_t number(const XmlTag& tag, const char* name) const {
    const std::string_view text = trimmed(tag.attribute(name));  // VTK fills up with blanks
    std::int64_t value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size() || value < 0)
      fail(tag.start, std::string(name) + " " + quoted(text) + " is not a number of items");
    if (value > largest_count) fail(tag.start, std::string(name) + " " + quoted(text) + " is too large");
    return value;
  }

  // Data of points and cells have arrays too, of no interest here but for texture coordinates.
  void array(const XmlTag& tag) {
    const auto& open = xml_.open();
    const std::size_t depth = open.size() - (tag.kind == XmlTag::Kind::open ? 1 : 0);
    const std::string_view parent = depth > 0 ? open[depth - 1] : std::string_view();
    const std::string_view name = tag.attribute("Name");
    if (parent == "Points")
      keep(tag, &Piece::points);
    else if (parent == "Cells" && name == "connectivity")
      keep(tag, &Piece::connectivity);
    else if (parent == "Cells" && name == "offsets")
      keep(tag, &Piece::offsets);
    else if (parent == "Cells" && name == "types")
      keep(tag, &Piece::types);
    else if (parent == "PointData" && wants_uv_ && !uv_name_.empty() && name == uv_name_)
      keep(tag, &Piece::uv);
  }

  void keep(const XmlTag& tag, VtuArray Piece::*array) {
    if (pieces_.empty()) fail(tag.start, "DataArray outside of a Piece");
    if ((pieces_.back().*array).present) fail(tag.start, "DataArray for the second time");
    pieces_.back().*array = describe_array(tag);
  }

  // What follows is not XML any more.
  void appended(const XmlTag& tag) {
    appended_seen_ = true;
    const std::string_view encoding = tag.attribute("encoding");
    if (encoding != "raw" && encoding != "base64")
      fail(tag.start, "appended data of encoding " + quoted(encoding) + ", which is neither raw nor base64");
    const std::size_t start = contents_.find_first_not_of(" \t\r\n", tag.end);
    if (start == std::string_view::npos || contents_[start] != '_')
      fail(tag.start, "appended data do not begin with an underscore");
    arrays_.set_appended(start + 1, encoding == "base64");
  }

  void add(const Piece& piece) {
    const std::int64_t before = static_cast<std::int64_t>(vertices_.size() / 3);
    if (before + piece.point_count > largest_count) fail(piece.start, "too many points");
    if (piece.point_count > 0) {
      require(piece, piece.points, "Points");
      if (component_count(piece.points) != 3)
        fail(piece.points.start, "points without NumberOfComponents=\"3\"");
      const std::vector<double> points = arrays_.tuples(piece.points, piece.point_count, "point");
      vertices_.insert(vertices_.end(), points.begin(), points.end());
      add_uv(piece, before);
    }
    if (piece.cell_count > 0) add_cells_of(piece, static_cast<int>(before));
  }

  // Two or three numbers a point, of which the third says nothing of a surface.
  void add_uv(const Piece& piece, std::int64_t before) {
    if (piece.uv.present ? static_cast<std::int64_t>(uv_.size()) != 2 * before : !uv_.empty())
      fail(piece.start, "texture coordinates in some pieces only");
    if (!piece.uv.present) return;
    const auto each = static_cast<std::size_t>(component_count(piece.uv));
    if (each < 2) fail(piece.uv.start, "texture coordinates need NumberOfComponents=\"2\" or \"3\"");
    const std::vector<double> values = arrays_.tuples(piece.uv, piece.point_count, "texture coordinate");
    for (std::size_t i = 0; i < values.size(); i += each) uv_.insert(uv_.end(), {values[i], values[i + 1]});
  }

  void add_cells_of(const Piece& piece, int first_point) {
    require(piece, piece.connectivity, "connectivity");
    require(piece, piece.offsets, "offsets");
    require(piece, piece.types, "types");
    const VtkCells cells = cells_of(piece);
    const auto types = arrays_.integers(piece.types, piece.cell_count, "types");
    add_cells(cells, types, first_point, static_cast<std::size_t>(piece.point_count),
              arrays_.place(piece.connectivity.start), elements_);
  }

  // The file leaves out the first offset, 0.
  VtkCells cells_of(const Piece& piece) {
    VtkCells cells;
    cells.offsets = arrays_.integers(piece.offsets, piece.cell_count, "offsets");
    cells.connectivity = arrays_.integers(piece.connectivity, cells.offsets.back(), "connectivity");
    cells.offsets.insert(cells.offsets.begin(), 0);
    require_offsets(cells, arrays_.place(piece.offsets.start));
    return cells;
  }

  void require(const Piece& piece, const VtuArray& array, const char* what) const {
    if (!array.present) fail(piece.start, std::string("Piece without ") + what);
  }

  std::string_view contents_;
  XmlScanner xml_;
  VtuArrays arrays_;
  ElementList elements_;
  bool file_seen_ = false;
  bool appended_seen_ = false;
  std::vector<Piece> pieces_;
  bool wants_uv_;
  std::string_view uv_name_;  // of the array in the point data that is open
  std::vector<double> vertices_, uv_;
};

}  // namespace

SurfaceMesh parse_vtu_surface(std::string_view contents, const std::string& name,
                              const ReadOptions& options) {
  return surface_of(VtuReader(contents, name, Wanted::surface, options).read());
}

TetMesh parse_vtu_tets(std::string_view contents, const std::string& name, const ReadOptions& options) {
  return tets_of(VtuReader(contents, name, Wanted::tets, options).read());
}

ElementMesh parse_vtu_elements(std::string_view contents, const std::string& name,
                               const ReadOptions& options) {
  return elements_of(VtuReader(contents, name, Wanted::elements, options).read());
}

SurfaceMesh read_vtu_surface(const std::string& path, const ReadOptions& options) {
  return parse_vtu_surface(read_file(path), path, options);
}

TetMesh read_vtu_tets(const std::string& path, const ReadOptions& options) {
  return parse_vtu_tets(read_file(path), path, options);
}

}  // namespace isostretch::mesh
