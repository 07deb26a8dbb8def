#include "characters.hpp"
#include "file.hpp"
#include "number.hpp"
#include "source.hpp"
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
      : source_(contents, name),
        elements_(wanted, options),
        wants_uv_(wanted == Wanted::surface && options.read_uv) {}

  MixedMesh read() {
    header();
    while (statement()) {
    }
    if (grid_.count() != types_.size())
      source_.fail(std::to_string(types_.size()) + " cell types for " + std::to_string(grid_.count()) +
                   " cells");
    add(grid_, types_, source_.place(grid_start_));
    const Place end = source_.place();
    std::vector<double> texture = wants_uv_ ? uv() : std::vector<double>();
    return {std::move(vertices_), std::move(elements_), end, std::move(texture)};
  }

 private:
  void header() {
    const std::string start = "# vtk DataFile Version ";
    const std::string_view line = source_.line();
    if (line.substr(0, start.size()) != start)
      source_.fail("not a VTK file: it does not begin with " + start);
    const std::string_view version = line.substr(start.size());
    if (version.size() < 3 || version[0] < '1' || version[0] > '5' || version[1] != '.')
      source_.fail("version " + quoted(version) + " is none of 1 to 5");
    offset_layout_ = version[0] == '5';
    source_.line();  // a title
    const std::string coding = lower(source_.word());
    if (coding != "ascii" && coding != "binary")
      source_.fail("ASCII or BINARY expected, not " + quoted(coding));
    source_.line();
    dataset();
    if (coding == "binary") source_.set_coding(Coding::big_endian);
  }

  void dataset() {
    if (lower(source_.word()) != "dataset") source_.fail("DATASET expected");
    const std::string kind = lower(source_.word());
    if (kind != "polydata" && kind != "unstructured_grid")
      source_.fail("dataset " + quoted(kind) + " is neither POLYDATA nor UNSTRUCTURED_GRID");
    source_.line();
  }

  // false: the geometry ends, with the file or where data of points and cells begin.
  bool statement() {
    const std::string keyword = lower(source_.word());
    data_start_ = source_.place().position;
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
      source_.fail("unknown keyword " + quoted(keyword));
    return true;
  }

  // A line that begins with the keyword, in capitals or not.
  std::size_t find_line(std::string_view keyword, std::size_t from) const {
    const std::string_view contents = source_.contents();
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
    source_.seek(start);
    source_.word();
    source_.word();  // their name
    const int each = source_.text_count("number of texture coordinates a point", 1);
    const Place place = source_.place();
    if (each < 2 || each > 3)
      place.fail("texture coordinates of " + std::to_string(each) + " numbers a point");
    const Scalar number = type();
    source_.line();
    const std::size_t points = vertices_.size() / 3;
    const int count =
        source_.checked_count(static_cast<std::int64_t>(points), "number of texture coordinates",
                              static_cast<std::size_t>(each) * bytes_of(number), place);
    std::vector<double> uv;
    for (std::int64_t i = 0; i < std::int64_t{each} * count; ++i) {
      const double value = source_.coordinate(number, "texture coordinate");
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
    const std::string name = lower(source_.word());
    if (const auto found = find_type(name)) return *found;
    source_.fail("unknown type " + quoted(name));
  }

  std::size_t bytes_of(Scalar type) const { return source_.binary() ? size_of(type) : 2; }

  void points() {
    if (has_points_) source_.fail("POINTS for the second time");
    has_points_ = true;
    const std::int64_t given = source_.text_integer("number of points");
    const Place place = source_.place();
    const Scalar number = type();
    source_.line();
    const int count = source_.checked_count(given, "number of points", 3 * bytes_of(number), place);
    vertices_ = source_.coordinates(number, 3 * static_cast<std::size_t>(count));
  }

  // Cells of one type, which need not be kept.
  void add_section(std::int64_t cell_type) {
    const Place place = source_.place();
    const VtkCells read = cells();
    add(read, std::vector<std::int64_t>(read.count(), cell_type), place);
  }

  void add(const VtkCells& cells, const std::vector<std::int64_t>& types, const Place& place) {
    add_cells(cells, types, 0, vertices_.size() / 3, place, elements_);
  }

  void grid() {
    if (grid_.count() > 0) source_.fail("CELLS for the second time");
    grid_start_ = source_.place().position;
    grid_ = cells();
  }

  void cell_types() {
    const std::int64_t given = source_.text_integer("number of cell types");
    source_.line();
    const int count =
        source_.checked_count(given, "number of cell types", bytes_of(Scalar::int32), source_.place());
    types_ = source_.integers(Scalar::int32, static_cast<std::size_t>(count), "cell type");
  }

  VtkCells cells() {
    if (!has_points_) source_.fail("cells before POINTS");
    const Place place = source_.place();
    VtkCells cells = offset_layout_ ? cells_with_offsets() : cells_with_counts();
    require_offsets(cells, place);
    return cells;
  }

  // Up to version 4: the number of cells and of integers; then every cell, its number of points in front.
  VtkCells cells_with_counts() {
    const int count = source_.text_count("number of cells", bytes_of(Scalar::int32));
    int left = source_.text_count("number of integers", bytes_of(Scalar::int32));
    source_.line();
    if (count > left) source_.fail("more cells than integers");
    VtkCells cells;
    cells.offsets.reserve(static_cast<std::size_t>(count) + 1);
    cells.connectivity.reserve(static_cast<std::size_t>(left - count));
    cells.offsets.push_back(0);
    for (int c = 0; c < count; ++c) {
      const std::int64_t points = source_.integer(Scalar::int32, "number of points of a cell");
      if (points < 0 || points >= left)
        source_.fail("cell " + std::to_string(c) + " of " + std::to_string(points) + " points with " +
                     std::to_string(left - 1) + " integers left");
      for (std::int64_t p = 0; p < points; ++p)
        cells.connectivity.push_back(source_.integer(Scalar::int32, "point index"));
      cells.offsets.push_back(static_cast<std::int64_t>(cells.connectivity.size()));
      left -= static_cast<int>(points) + 1;
    }
    if (left != 0) source_.fail(std::to_string(left) + " integers follow the last cell");
    return cells;
  }

  // From version 5: the lengths of two arrays, which follow.
  VtkCells cells_with_offsets() {
    const int offsets = source_.text_count("number of offsets", 2);
    const int points = source_.text_count("length of the connectivity", 2);
    source_.line();
    VtkCells cells;
    if (offsets == 0) return cells;
    cells.offsets = array("offsets", offsets);
    cells.connectivity = array("connectivity", points);
    return cells;
  }

  std::vector<std::int64_t> array(const char* keyword, int count) {
    if (lower(source_.word()) != keyword) source_.fail(std::string(keyword) + " expected");
    const Scalar number = type();
    if (is_real(number)) source_.fail(std::string(keyword) + " are not of an integer type");
    const Place place = source_.place();
    source_.line();
    source_.checked_count(count, keyword, bytes_of(number), place);
    return source_.integers(number, static_cast<std::size_t>(count), keyword);
  }

  // Ends with an empty line.
  void skip_metadata() {
    source_.line();
    while (source_.left() > 0 && !source_.line().empty()) {
    }
  }

  void skip_field() {
    source_.word();  // its name
    for (int arrays = source_.text_count("number of arrays", 8); arrays > 0; --arrays) skip_array();
  }

  // VTK puts names of components between the arrays.
  void skip_array() {
    std::string_view name = source_.word();
    while (lower(name) == "metadata" && trimmed(source_.rest_of_line()).empty()) {
      skip_metadata();
      name = source_.word();
    }
    const int components = source_.text_count("number of components", 1);
    const int tuples = source_.text_count("number of tuples", 1);
    const Place place = source_.place();
    const std::string type = lower(source_.word());
    if (type.empty()) source_.fail("the file ends within an array");
    source_.line();
    skip_values(type, std::int64_t{components} * tuples, place);
  }

  // Nothing in the arrays is used, and texts may stand in them.
  void skip_values(const std::string& type, std::int64_t count, const Place& place) {
    const std::optional<Scalar> number = find_type(type);
    const bool texts = type == "string" || type == "utf8_string";
    if (source_.binary() && number) {
      source_.checked_count(count, "length of an array", size_of(*number), place);
      source_.bytes(static_cast<std::size_t>(count) * size_of(*number), "array");
    } else if (source_.binary() && type == "bit") {
      source_.bytes(static_cast<std::size_t>((count + 7) / 8), "array");
    } else if (source_.binary() && texts) {
      for (std::int64_t i = 0; i < count; ++i) skip_text();
    } else if (texts || type == "variant") {
      source_.checked_count(count, "length of an array", 1, place);
      for (std::int64_t i = 0; i < count; ++i) source_.line();
    } else if (source_.binary()) {
      place.fail("array of unknown type " + quoted(type));
    } else {
      source_.checked_count(count, "length of an array", 2, place);
      for (std::int64_t i = 0; i < count; ++i)
        if (source_.word().empty()) source_.fail("the file ends within an array");
    }
  }

  // Two bits say in how many bytes the length is, themselves included.
  void skip_text() {
    const std::int64_t first = source_.integer(Scalar::uint8, "length of a text");
    constexpr int sizes[] = {8, 4, 2, 1};
    std::uint64_t length = static_cast<std::uint64_t>(first & 63);
    for (int i = sizes[first >> 6]; i > 1; --i)
      length = length << 8 | static_cast<std::uint64_t>(source_.integer(Scalar::uint8, "length of a text"));
    if (length > source_.left()) source_.fail("the file ends within a text");
    source_.bytes(static_cast<std::size_t>(length), "text");
  }

  static constexpr int no_type = 0;

  Source source_;
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
