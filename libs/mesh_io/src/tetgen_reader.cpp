#include "elements.hpp"
#include "file.hpp"
#include "input_cursor.hpp"
#include "number.hpp"

#include <isostretch/mesh_io/io.hpp>

#include <algorithm>
#include <array>
#include <filesystem>
#include <utility>

namespace isostretch::mesh {
namespace {

// One of the two files: a line of counts, then an item a line, its number in front.
class Table {
 public:
  Table(std::string_view text, const std::string& name) : cursor_(text, name) {
    cursor_.set_comments(true);
    cursor_.set_by_line(true);
    cursor_.next_line();
  }

  InputCursor& cursor() { return cursor_; }
  // Numbers of the first line that may be missing.
  int optional_count(const char* what) { return cursor_.empty() ? 0 : cursor_.text_count(what, 1); }

  // To the next item, whose number follows that of the one before; the first is 0 or 1, or `first`.
  std::int64_t next(int item, int count, const char* what) {
    const Place before = cursor_.place();
    cursor_.next_line();
    if (cursor_.left() == 0)
      before.fail("the file ends after " + std::to_string(item) + " of " + std::to_string(count) + " " +
                  what);
    const std::int64_t number = cursor_.text_integer("number of the item");
    if (item == 0) first_ = number;
    if (item == 0 && number != 0 && number != 1)
      cursor_.fail("numbers begin with " + std::to_string(number) + ", neither 0 nor 1");
    if (number != first_ + item)
      cursor_.fail("number " + std::to_string(first_ + item) + " expected, not " + std::to_string(number));
    return number;
  }
  int first() const { return static_cast<int>(first_); }

 private:
  InputCursor cursor_;
  std::int64_t first_ = 0;
};

class TetgenReader {
 public:
  TetgenReader(const TetgenFiles& files, Wanted wanted, const ReadOptions& options)
      : nodes_(files.node, files.node_name), tets_(files.ele, files.ele_name), elements_(wanted, options) {}

  MixedMesh read() {
    read_nodes();
    read_tets();
    return {std::move(vertices_), std::move(elements_), tets_.cursor().place()};
  }

 private:
  // Number, dimension 3, numbers of attributes and markers, which are not read.
  void read_nodes() {
    InputCursor& cursor = nodes_.cursor();
    if (cursor.left() == 0) cursor.fail("no nodes");
    const std::int64_t given = cursor.text_integer("number of nodes");
    const Place place = cursor.place();
    const std::int64_t dimension = cursor.text_integer("dimension");
    if (dimension != 3) cursor.fail("dimension " + std::to_string(dimension) + " is not 3");
    const int count = cursor.checked_count(given, "number of nodes", 8, place);
    for (int n = 0; n < count; ++n) {
      nodes_.next(n, count, "nodes");
      for (const char* axis : axis_labels) vertices_.push_back(cursor.text_coordinate(axis));
    }
  }

  // Number, nodes of each (4 or 10), number of attributes, the first of which is a region.
  void read_tets() {
    InputCursor& cursor = tets_.cursor();
    if (cursor.left() == 0) cursor.fail("no tetrahedra");
    const int count = cursor.text_count("number of tetrahedra", 10);
    const std::int64_t corners = cursor.empty() ? 4 : cursor.text_integer("nodes of a tetrahedron");
    if (corners != 4 && corners != 10)
      cursor.fail("tetrahedra of " + std::to_string(corners) +
                  " nodes are neither linear nor of second order");
    const CellKind kind = {Family::tet, static_cast<int>(corners)};
    const bool regions = tets_.optional_count("number of attributes") > 0;
    for (int t = 0; t < count; ++t) {
      tets_.next(t, count, "tetrahedra");
      if (elements_.wants(kind))
        add(kind, regions);
      else
        elements_.skip(kind);
    }
    if (kind.nodes == 10) order_edge_nodes();
  }

  void add(CellKind kind, bool regions) {
    InputCursor& cursor = tets_.cursor();
    const Place place = cursor.place();
    corners_.clear();
    for (int c = 0; c < kind.nodes; ++c)
      corners_.push_back(cursor.index(Scalar::int32, "node", nodes_.first(), vertices_.size() / 3));
    ElementLabel label;
    if (regions && !cursor.empty()) {
      const Parsed<double> region = parse_coordinate(cursor.word());
      const auto number = static_cast<std::int64_t>(std::clamp(region.value, -1e15, 1e15));
      if (region.fault.empty() && number != 0 && static_cast<double>(number) == region.value)
        label.groups.push_back(number);
    }
    elements_.add(kind, corners_, place, label);
  }

  // TetGen puts every node of second order in the middle of its edge, which tells the order of the nodes.
  void order_edge_nodes() {
    std::vector<int>& nodes = elements_.nodes_of(Shape::quadratic_tet);
    for (std::size_t e = 0; e < nodes.size(); e += 10) {
      std::array<int, 6> ordered{};
      ordered.fill(-1);
      for (std::size_t k = 4; k < 10; ++k) ordered[nearest_edge(nodes, e, nodes[e + k])] = nodes[e + k];
      if (std::find(ordered.begin(), ordered.end(), -1) != ordered.end())
        tets_.cursor().fail("tetrahedron " + std::to_string(e / 10) +
                            ": its nodes of second order are not in the middle of its edges");
      std::copy(ordered.begin(), ordered.end(), nodes.begin() + static_cast<std::ptrdiff_t>(e + 4));
    }
  }

  // In VTK's order of the edges.
  std::size_t nearest_edge(const std::vector<int>& nodes, std::size_t e, int node) const {
    constexpr std::size_t edges[6][2] = {{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 3}, {2, 3}};
    const auto at = [this](int v, std::size_t axis) {
      return vertices_[3 * static_cast<std::size_t>(v) + axis];
    };
    std::array<double, 6> distance{};
    for (std::size_t k = 0; k < 6; ++k)
      for (std::size_t i = 0; i < 3; ++i) {
        const double d = at(node, i) - (at(nodes[e + edges[k][0]], i) + at(nodes[e + edges[k][1]], i)) / 2;
        distance[k] += d * d;
      }
    return static_cast<std::size_t>(std::min_element(distance.begin(), distance.end()) - distance.begin());
  }

  Table nodes_, tets_;
  ElementList elements_;
  std::vector<double> vertices_;
  std::vector<int> corners_;  // of the element being read
};

// A pair of files is named by either of them.
struct Pair {
  explicit Pair(const std::string& path)
      : node(std::filesystem::path(path).replace_extension(".node").string()),
        ele(std::filesystem::path(path).replace_extension(".ele").string()) {
    (lower(std::filesystem::path(path).extension().string()) == ".node" ? node : ele) = path;
    node_text = read_file(node);
    ele_text = read_file(ele);
  }
  TetgenFiles files() const { return {node_text, node, ele_text, ele}; }

  std::string node, ele, node_text, ele_text;
};

}  // namespace

TetMesh parse_tetgen_tets(const TetgenFiles& files, const ReadOptions& options) {
  return tets_of(TetgenReader(files, Wanted::tets, options).read());
}

ElementMesh parse_tetgen_elements(const TetgenFiles& files, const ReadOptions& options) {
  return elements_of(TetgenReader(files, Wanted::elements, options).read());
}

TetMesh read_tetgen_tets(const std::string& path, const ReadOptions& options) {
  const Pair pair(path);
  return parse_tetgen_tets(pair.files(), options);
}

ElementMesh read_tetgen_elements(const std::string& path, const ReadOptions& options) {
  const Pair pair(path);
  return parse_tetgen_elements(pair.files(), options);
}

}  // namespace isostretch::mesh
