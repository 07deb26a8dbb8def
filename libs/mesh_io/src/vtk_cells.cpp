#include "vtk_cells.hpp"

#include "input_cursor.hpp"

#include <utility>

namespace isostretch::mesh {
namespace {

constexpr int pixel = 8;
constexpr int voxel = 11;

// Of a cell of so many points.
CellKind kind_of(std::int64_t type, int points) {
  using enum Family;
  switch (type) {
    case vtk_triangle:
    case 22:  // of second order
    case 34:  // with a node in the middle
    case 69:  // Lagrange
    case 76:  // Bezier
      return {triangle, points};
    case vtk_polygon:
    case 36:  // of second order
      return {polygon, type == vtk_polygon ? points : 0};
    case pixel:
    case vtk_quad:
    case 23:
    case 28:
    case 30:
    case 70:
    case 77:
      return {quad, points};
    case vtk_tet:
    case vtk_quadratic_tet:
    case 71:
    case 78:
      return {tet, points};
    case voxel:
    case vtk_hex:
    case 25:
    case 29:
    case 33:
    case 72:
    case 79:
      return {hex, points};
    case 13:
    case 26:
    case 31:
    case 32:
    case 73:
    case 80:
      return {prism, points};
    case 14:
    case 27:
    case 37:
    case 74:
    case 81:
      return {pyramid, points};
    case 15:  // prisms over a pentagon and a hexagon
    case 16:
    case 41:  // convex point sets
    case 42:
      return {polyhedron, 0};
    case 3:
    case 4:
    case 21:
    case 35:
    case 68:
    case 75:
      return {line, 0};
    default:
      return {point, 0};
  }
}

// The cells of one file, one after the other.
class CellAdder {
 public:
  CellAdder(const VtkCells& cells, int first_point, std::size_t point_count, const Place& place,
            ElementList& elements)
      : cells_(cells),
        first_point_(first_point),
        point_count_(point_count),
        place_(place),
        elements_(elements) {}

  void add(std::size_t cell, std::int64_t type) {
    if (type == vtk_triangle_strip) {
      add_strip(cell);
      return;
    }
    const std::int64_t points = cells_.offsets[cell + 1] - cells_.offsets[cell];
    const CellKind kind = kind_of(type, static_cast<int>(points));
    if (!elements_.wants(kind)) {
      if (is_linear(type) && points != linear_size(type)) fail(cell, counted(kind, 1));
      elements_.skip(kind);
      return;
    }
    take_points(cell);
    // The corners of pixels and voxels are numbered row by row.
    if (type == pixel || type == voxel) std::swap(points_[2], points_[3]);
    if (type == voxel) std::swap(points_[6], points_[7]);
    add_element(cell, kind, points_);
  }

 private:
  // What has so many points by its type, and no other number.
  static bool is_linear(std::int64_t type) { return linear_size(type) > 0; }
  static std::int64_t linear_size(std::int64_t type) {
    switch (type) {
      case vtk_triangle:
        return 3;
      case pixel:
      case vtk_quad:
      case vtk_tet:
        return 4;
      case vtk_quadratic_tet:
        return 10;
      case voxel:
      case vtk_hex:
        return 8;
      default:
        return 0;
    }
  }

  void take_points(std::size_t cell) {
    points_.clear();
    for (std::int64_t i = cells_.offsets[cell]; i < cells_.offsets[cell + 1]; ++i) {
      const std::int64_t given = cells_.connectivity[static_cast<std::size_t>(i)];
      if (given < 0 || static_cast<std::uint64_t>(given) >= point_count_)
        fail(cell, out_of_range("point index", given, point_count_));
      points_.push_back(first_point_ + static_cast<int>(given));
    }
  }

  // Faults of the element itself name the cell too.
  void add_element(std::size_t cell, CellKind kind, const std::vector<int>& points) {
    if (kind.dimension() == 2)
      if (const std::string fault = elements_.face_fault(points.size()); !fault.empty()) fail(cell, fault);
    elements_.add(kind, points, place_);
  }

  // Every other triangle of a strip runs the other way round.
  void add_strip(std::size_t cell) {
    const auto size = static_cast<long>(cells_.offsets[cell + 1] - cells_.offsets[cell]);
    constexpr CellKind kind = {Family::triangle, 3};
    if (size < 3) fail(cell, "strip with " + std::to_string(size) + " vertices");
    if (!elements_.wants(kind)) {
      elements_.skip(kind, size - 2);
      return;
    }
    take_points(cell);
    for (std::size_t i = 2; i < points_.size(); ++i) {
      const bool turned = i % 2 == 1;
      triangle_ = {points_[i - 2], points_[turned ? i : i - 1], points_[turned ? i - 1 : i]};
      add_element(cell, kind, triangle_);
    }
  }

  [[noreturn]] void fail(std::size_t cell, const std::string& what) const {
    place_.fail("cell " + std::to_string(cell) + ": " + what);
  }

  const VtkCells& cells_;
  int first_point_;
  std::size_t point_count_;
  const Place& place_;
  ElementList& elements_;
  std::vector<int> points_;  // of the cell being added
  std::vector<int> triangle_;
};

}  // namespace

void require_offsets(const VtkCells& cells, const Place& place) {
  std::int64_t before = 0;
  for (const std::int64_t offset : cells.offsets) {
    if (offset < before)
      place.fail("offset " + std::to_string(offset) + " of a cell is below the one before");
    before = offset;
  }
  if (!cells.offsets.empty() && cells.offsets.front() != 0)
    place.fail("offsets begin with " + std::to_string(cells.offsets.front()) + " instead of 0");
  if (static_cast<std::size_t>(before) != cells.connectivity.size())
    place.fail("offsets end at " + std::to_string(before) + ", there are " +
               std::to_string(cells.connectivity.size()) + " numbers in the cells");
}

void add_cells(const VtkCells& cells, const std::vector<std::int64_t>& types, int first_point,
               std::size_t point_count, const Place& place, ElementList& elements) {
  CellAdder adder(cells, first_point, point_count, place, elements);
  for (std::size_t c = 0; c < cells.count(); ++c) adder.add(c, types[c]);
}

}  // namespace isostretch::mesh
