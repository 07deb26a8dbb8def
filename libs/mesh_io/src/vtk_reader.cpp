#include "characters.hpp"
#include "file.hpp"
#include "input_cursor.hpp"
#include "number.hpp"
#include "vtk_cells.hpp"

#include <isostretch/mesh_io/io.hpp>

#include <array>
#include <optional>
#include <utility>

namespace isostretch::mesh {
namespace {

class VtkReader {
 public:
  VtkReader(std::string_view contents, const std::string& name, Wanted wanted, const ReadOptions& options)
      : cursor_(contents, name),
        elements_(wanted, options),
        wants_uv_(wanted == Wanted::surface && options.read_uv) {}

  MixedMesh read() {
    header();
    while (statement()) {
    }
    if (grid_.count() != types_.size())
      cursor_.fail(std::to_string(types_.size()) + " cell types for " + std::to_string(grid_.count()) +
                   " cells");
    add(grid_, types_, cursor_.place(grid_start_));
    const Place end = cursor_.place();
    std::vector<double> texture = wants_uv_ ? uv() : std::vector<double>();
    return {std::move(vertices_), std::move(elements_), end, std::move(texture)};
  }

 private:
  void header() {
    const std::string start = "# vtk DataFile Version ";
    const std::string_view line = cursor_.line();
    if (line.substr(0, start.size()) != start)
      cursor_.fail("not a VTK file: it does not begin with " + start);
    const std::string_view version = line.substr(start.size());
    if (version.size() < 3 || version[0] < '1' || version[0] > '5' || version[1] != '.')
      cursor_.fail("version " + quoted(version) + " is none of 1 to 5");
    offset_layout_ = version[0] == '5';
    cursor_.line();  // a title
    const std::string coding = lower(cursor_.word());
    if (coding != "ascii" && coding != "binary")
      cursor_.fail("ASCII or BINARY expected, not " + quoted(coding));
    cursor_.line();
    dataset();
    if (coding == "binary") cursor_.set_coding(Coding::big_endian);
  }

  void dataset() {
    if (lower(cursor_.word()) != "dataset") cursor_.fail("DATASET expected");
    const std::string kind = lower(cursor_.word());
    if (kind != "polydata" && kind != "unstructured_grid")
      cursor_.fail("dataset " + quoted(kind) + " is neither POLYDATA nor UNSTRUCTURED_GRID");
    cursor_.line();
  }

  // false: the geometry ends, with the file or where data of points and cells begin.
  bool statement() {
    const std::string keyword = lower(cursor_.word());
    data_start_ = cursor_.place().position;
    if (keyword.empty() || keyword == "point_data" || keyword == "cell_data") return false;
    if (keyword == "points")
      points();
    else if (keyword == "polygons")
      add_section(vtk_polygon);
    else if (keyword == "triangle_strips")
      add_section(vtk_triangle_strip);
    else if (keyword == "vertices" || keyword == "lines")
      add_section(no_type);
    else if (keyword == "cells")
      grid();
    else if (keyword == "cell_types")
      cell_types();
    else if (keyword == "metadata")
      skip_metadata();
    else if (keyword == "field")
      skip_field();
    else
      cursor_.fail("unknown keyword " + quoted(keyword));
    return true;
  }

  // A line that begins with the keyword, in capitals or not.
  std::size_t find_line(std::string_view keyword, std::size_t from) const {
    const std::string_view contents = cursor_.contents();
    const auto equal = [](char a, char b) { return lower(std::string_view(&a, 1))[0] == b; };
    for (;;) {
      const auto found = std::search(contents.begin() + static_cast<std::ptrdiff_t>(from), contents.end(),
                                     keyword.begin(), keyword.end(), equal);
      if (found == contents.end()) return std::string_view::npos;
      const auto position = static_cast<std::size_t>(found - contents.begin());
      if (position > 0 && (contents[position - 1] == '\n' || contents[position - 1] == '\r')) return position;
      from = position + 1;
    }
  }

  // Of points, and not of cells.
  std::size_t find_uv() const {
    const std::size_t points = find_line("point_data ", data_start_),
                      cells = find_line("cell_data ", data_start_);
    if (points == std::string_view::npos) return points;
    const std::size_t found = find_line("texture_coordinates ", points);
    return points < cells && cells < found ? std::string_view::npos : found;
  }

  // Of what else is said of points there are many kinds, which need not be known: the line is looked for.
  std::vector<double> uv() {
    const std::size_t start = find_uv();
    if (start == std::string_view::npos) return {};
    cursor_.seek(start);
    cursor_.word();
    cursor_.word();  // their name
    const int each = cursor_.text_count("number of texture coordinates a point", 1);
    const Place place = cursor_.place();
    if (each < 2 || each > 3)
      place.fail("texture coordinates of " + std::to_string(each) + " numbers a point");
    const Scalar number = type();
    cursor_.line();
    const std::size_t points = vertices_.size() / 3;
    const int count =
        cursor_.checked_count(static_cast<std::int64_t>(points), "number of texture coordinates",
                              static_cast<std::size_t>(each) * bytes_of(number), place);
    std::vector<double> uv;
    for (std::int64_t i = 0; i < std::int64_t{each} * count; ++i) {
      const double value = cursor_.coordinate(number, "texture coordinate");
      if (i % each < 2) uv.push_back(value);
    }
    return uv;
  }

  static std::optional<Scalar> find_type(std::string_view name) {
    constexpr std::array<std::pair<std::string_view, Scalar>, 18> types = {
        {{"char", Scalar::int8},
         {"signed_char", Scalar::int8},
         {"unsigned_char", Scalar::uint8},
         {"short", Scalar::int16},
         {"unsigned_short", Scalar::uint16},
         {"int", Scalar::int32},
         {"unsigned_int", Scalar::uint32},
         {"long", Scalar::int64},
         {"unsigned_long", Scalar::uint64},
         {"float", Scalar::float32},
         {"double", Scalar::float64},
         {"vtkidtype", Scalar::int32},
         {"vtktypeint32", Scalar::int32},
         {"vtktypeuint32", Scalar::uint32},
         {"vtktypeint64", Scalar::int64},
         {"vtktypeuint64", Scalar::uint64},
         {"vtktypefloat32", Scalar::float32},
         {"vtktypefloat64", Scalar::float64}}};
    for (const auto& [known, type] : types)
      if (known == name) return type;
    return std::nullopt;
  }

  Scalar type() {
    const std::string name = lower(cursor_.word());
    if (const auto found = find_type(name)) return *found;
    cursor_.fail("unknown type " + quoted(name));
  }

  std::size_t bytes_of(Scalar type) const { return cursor_.binary() ? size_of(type) : 2; }

  void points() {
    if (has_points_) cursor_.fail("POINTS for the second time");
    has_points_ = true;
    const std::int64_t given = cursor_.text_integer("number of points");
    const Place place = cursor_.place();
    const Scalar number = type();
    cursor_.line();
    const int count = cursor_.checked_count(given, "number of points", 3 * bytes_of(number), place);
    vertices_ = cursor_.coordinates(number, 3 * static_cast<std::size_t>(count));
  }

  // Cells of one type, which need not be kept.
  void add_section(std::int64_t cell_type) {
    const Place place = cursor_.place();
    const VtkCells read = cells();
    add(read, std::vector<std::int64_t>(read.count(), cell_type), place);
  }

  void add(const VtkCells& cells, const std::vector<std::int64_t>& types, const Place& place) {
    add_cells(cells, types, 0, vertices_.size() / 3, place, elements_);
  }

  void grid() {
    if (grid_.count() > 0) cursor_.fail("CELLS for the second time");
    grid_start_ = cursor_.place().position;
    grid_ = cells();
  }

  void cell_types() {
    const std::int64_t given = cursor_.text_integer("number of cell types");
    cursor_.line();
    const int count =
        cursor_.checked_count(given, "number of cell types", bytes_of(Scalar::int32), cursor_.place());
    types_ = cursor_.integers(Scalar::int32, static_cast<std::size_t>(count), "cell type");
  }

  VtkCells cells() {
    if (!has_points_) cursor_.fail("cells before POINTS");
    const Place place = cursor_.place();
    VtkCells cells = offset_layout_ ? cells_with_offsets() : cells_with_counts();
    require_offsets(cells, place);
    return cells;
  }

  // Up to version 4: the number of cells and of integers; then every cell, its number of points in front.
  VtkCells cells_with_counts() {
    const int count = cursor_.text_count("number of cells", bytes_of(Scalar::int32));
    int left = cursor_.text_count("number of integers", bytes_of(Scalar::int32));
    cursor_.line();
    if (count > left) cursor_.fail("more cells than integers");
    VtkCells cells;
    cells.offsets.reserve(static_cast<std::size_t>(count) + 1);
    cells.connectivity.reserve(static_cast<std::size_t>(left - count));
    cells.offsets.push_back(0);
    for (int c = 0; c < count; ++c) {
      const std::int64_t points = cursor_.integer(Scalar::int32, "number of points of a cell");
      if (points < 0 || points >= left)
        cursor_.fail("cell " + std::to_string(c) + " of " + std::to_string(points) + " points with " +
                     std::to_string(left - 1) + " integers left");
      for (std::int64_t p = 0; p < points; ++p)
        cells.connectivity.push_back(cursor_.integer(Scalar::int32, "point index"));
      cells.offsets.push_back(static_cast<std::int64_t>(cells.connectivity.size()));
      left -= static_cast<int>(points) + 1;
    }
    if (left != 0) cursor_.fail(std::to_string(left) + " integers follow the last cell");
    return cells;
  }

  // From version 5: the lengths of two arrays, which follow.
  VtkCells cells_with_offsets() {
    const int offsets = cursor_.text_count("number of offsets", 2);
    const int points = cursor_.text_count("length of the connectivity", 2);
    cursor_.line();
    VtkCells cells;
    if (offsets == 0) return cells;
    cells.offsets = array("offsets", offsets);
    cells.connectivity = array("connectivity", points);
    return cells;
  }

  std::vector<std::int64_t> array(const char* keyword, int count) {
    if (lower(cursor_.word()) != keyword) cursor_.fail(std::string(keyword) + " expected");
    const Scalar number = type();
    if (is_real(number)) cursor_.fail(std::string(keyword) + " are not of an integer type");
    const Place place = cursor_.place();
    cursor_.line();
    cursor_.checked_count(count, keyword, bytes_of(number), place);
    return cursor_.integers(number, static_cast<std::size_t>(count), keyword);
  }

  // Ends with an empty line.
  void skip_metadata() {
    cursor_.line();
    while (cursor_.left() > 0 && !cursor_.line().empty()) {
    }
  }

  void skip_field() {
    cursor_.word();  // its name
    for (int arrays = cursor_.text_count("number of arrays", 8); arrays > 0; --arrays) skip_array();
  }

  // VTK puts names of components between the arrays.
  void skip_array() {
    std::string_view name = cursor_.word();
    while (lower(name) == "metadata" && trimmed(cursor_.rest_of_line()).empty()) {
      skip_metadata();
      name = cursor_.word();
    }
    const int components = cursor_.text_count("number of components", 1);
    const int tuples = cursor_.text_count("number of tuples", 1);
    const Place place = cursor_.place();
    const std::string type = lower(cursor_.word());
    if (type.empty()) cursor_.fail("the file ends within an array");
    cursor_.line();
    skip_values(type, std::int64_t{components} * tuples, place);
  }

  // Nothing in the arrays is used, and texts may stand in them.
  void skip_values(const std::string& type, std::int64_t count, const Place& place) {
    const std::optional<Scalar> number = find_type(type);
    const bool texts = type == "string" || type == "utf8_string";
    if (cursor_.binary() && number) {
      cursor_.checked_count(count, "length of an array", size_of(*number), place);
      cursor_.bytes(static_cast<std::size_t>(count) * size_of(*number), "array");
    } else if (cursor_.binary() && type == "bit") {
      cursor_.bytes(static_cast<std::size_t>((count + 7) / 8), "array");
    } else if (cursor_.binary() && texts) {
      for (std::int64_t i = 0; i < count; ++i) skip_text();
    } else if (texts || type == "variant") {
      cursor_.checked_count(count, "length of an array", 1, place);
      for (std::int64_t i = 0; i < count; ++i) cursor_.line();
    } else if (cursor_.binary()) {
      place.fail("array of unknown type " + quoted(type));
    } else {
      cursor_.checked_count(count, "length of an array", 2, place);
      for (std::int64_t i = 0; i < count; ++i)
        if (cursor_.word().empty()) cursor_.fail("the file ends within an array");
    }
  }

  // Two bits say in how many bytes the length is, themselves included.
  void skip_text() {
    const std::int64_t first = cursor_.integer(Scalar::uint8, "length of a text");
    constexpr int sizes[] = {8, 4, 2, 1};
    std::uint64_t length = static_cast<std::uint64_t>(first & 63);
    for (int i = sizes[first >> 6]; i > 1; --i)
      length = length << 8 | static_cast<std::uint64_t>(cursor_.integer(Scalar::uint8, "length of a text"));
    if (length > cursor_.left()) cursor_.fail("the file ends within a text");
    cursor_.bytes(static_cast<std::size_t>(length), "text");
  }

  static constexpr int no_type = 0;

  InputCursor cursor_;
  ElementList elements_;
  bool offset_layout_ = false;
  bool has_points_ = false;
  std::vector<double> vertices_;
  VtkCells grid_;
  std::vector<std::int64_t> types_;
  std::size_t grid_start_ = 0;
  bool wants_uv_;
  std::size_t data_start_ = 0;  // behind the geometry
};

}  // namespace

SurfaceMesh parse_vtk_surface(std::string_view contents, const std::string& name,
                              const ReadOptions& options) {
  return surface_of(VtkReader(contents, name, Wanted::surface, options).read());
}

TetMesh parse_vtk_tets(std::string_view contents, const std::string& name, const ReadOptions& options) {
  return tets_of(VtkReader(contents, name, Wanted::tets, options).read());
}

ElementMesh parse_vtk_elements(std::string_view contents, const std::string& name,
                               const ReadOptions& options) {
  return elements_of(VtkReader(contents, name, Wanted::elements, options).read());
}

SurfaceMesh read_vtk_surface(const std::string& path, const ReadOptions& options) {
  return parse_vtk_surface(read_file(path), path, options);
}

TetMesh read_vtk_tets(const std::string& path, const ReadOptions& options) {
  return parse_vtk_tets(read_file(path), path, options);
}

}  // namespace isostretch::mesh
