#include "elements.hpp"
#include "file.hpp"
#include "input_cursor.hpp"
#include "number.hpp"

#include <isostretch/mesh_io/io.hpp>

#include <cmath>
#include <utility>

namespace isostretch::mesh {
namespace {

struct Section {
  const char* keyword;  // in lower case: files differ in End and END
  CellKind kind;
};
constexpr Section element_sections[] = {{"edges", {Family::line, 2}},
                                        {"triangles", {Family::triangle, 3}},
                                        {"trianglesp2", {Family::triangle, 6}},
                                        {"quadrilaterals", {Family::quad, 4}},
                                        {"quadrilateralsq2", {Family::quad, 9}},
                                        {"tetrahedra", {Family::tet, 4}},
                                        {"tetrahedrap2", {Family::tet, 10}},
                                        {"hexahedra", {Family::hex, 8}},
                                        {"hexahedraq2", {Family::hex, 27}},
                                        {"prisms", {Family::prism, 6}},
                                        {"pyramids", {Family::pyramid, 5}}};

bool is_letter(char c) {
  return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z');
}

class MeditReader {
 public:
  MeditReader(std::string_view text, const std::string& name, Wanted wanted, const ReadOptions& options)
      : cursor_(text, name), elements_(wanted, options) {
    cursor_.set_comments(true);
  }

  MixedMesh read() {
    header();
    sections();
    for (const auto& [section, position] : postponed_) {
      cursor_.seek(position);
      read_elements(*section);
    }
    order_edge_nodes();
    return {std::move(vertices_), std::move(elements_), cursor_.place()};
  }

 private:
  void header() {
    if (lower(cursor_.word()) != "meshversionformatted")
      cursor_.fail("not a MEDIT file: it does not begin with MeshVersionFormatted");
    cursor_.text_integer("version");
  }

  void sections() {
    for (std::string_view word = cursor_.word(); !word.empty(); word = cursor_.word()) {
      if (!is_letter(word.front())) cursor_.fail("keyword expected, not " + quoted(word));
      const std::string keyword = lower(word);
      if (keyword == "end") return;
      if (keyword == "dimension")
        dimension();
      else if (keyword == "vertices")
        vertices();
      else if (const Section* section = element_section(keyword))
        elements(*section);
      else
        skip_numbers();
    }
  }

  static const Section* element_section(std::string_view keyword) {
    for (const Section& section : element_sections)
      if (keyword == section.keyword) return &section;
    return nullptr;
  }

  void dimension() {
    const std::int64_t given = cursor_.text_integer("dimension");
    if (given != 2 && given != 3) cursor_.fail("dimension " + std::to_string(given) + " is neither 2 nor 3");
    dimension_ = static_cast<int>(given);
  }

  void vertices() {
    if (dimension_ == 0) cursor_.fail("Vertices before Dimension");
    if (has_vertices_) cursor_.fail("Vertices for the second time");
    has_vertices_ = true;
    const int count = cursor_.text_count("number of vertices", 2 * static_cast<std::size_t>(dimension_ + 1));
    vertices_.assign(3 * static_cast<std::size_t>(count), 0.0);
    for (double* v = vertices_.data(); v < vertices_.data() + vertices_.size(); v += 3) {
      for (int a = 0; a < dimension_; ++a) v[a] = cursor_.text_coordinate(axis_labels[a]);
      reference();
    }
  }

  // Some programs write it as a real number, which names no group; 0 is none.
  std::vector<std::int64_t> reference() {
    const std::string_view word = cursor_.word();
    if (word.empty()) cursor_.fail("missing reference");
    const Parsed<std::int64_t> parsed = parse_integer(word);
    if (!parsed.fault.empty() || parsed.value == 0) return {};
    return {parsed.value};
  }

  // Elements may stand before the vertices that they name.
  void elements(const Section& section) {
    if (!has_vertices_) postponed_.emplace_back(&section, cursor_.position());
    if (!has_vertices_)
      skip_numbers();
    else
      read_elements(section);
  }

  void read_elements(const Section& section) {
    const int count =
        cursor_.text_count("number of elements", 2 * static_cast<std::size_t>(section.kind.nodes + 1));
    for (int e = 0; e < count; ++e) {
      if (elements_.wants(section.kind))
        element(section.kind);
      else
        skip_element(section);
    }
  }

  void element(CellKind kind) {
    corners_.clear();
    Place place = cursor_.place();
    for (int c = 0; c < kind.nodes; ++c) {
      corners_.push_back(cursor_.index(Scalar::int32, "vertex index", 1, vertices_.size() / 3));
      if (c == 0) place.position = cursor_.place().position;
    }
    elements_.add(kind, corners_, place, {0, 0, reference()});
  }

  void skip_element(const Section& section) {
    for (int c = 0; c <= section.kind.nodes; ++c)
      if (cursor_.word().empty()) cursor_.fail("the file ends within " + std::string(section.keyword));
    elements_.skip(section.kind);
  }

  // Programs disagree in which order the last two nodes of a tetrahedron of second order come: they are where
  // the nodes lie.
  void order_edge_nodes() {
    std::vector<int>& nodes = elements_.nodes_of(Shape::quadratic_tet);
    double as_given = 0, swapped = 0;
    for (std::size_t e = 0; e < nodes.size(); e += 10) {
      as_given += distance_to_edge(nodes[e + 8], nodes[e + 1], nodes[e + 3]) +
                  distance_to_edge(nodes[e + 9], nodes[e + 2], nodes[e + 3]);
      swapped += distance_to_edge(nodes[e + 8], nodes[e + 2], nodes[e + 3]) +
                 distance_to_edge(nodes[e + 9], nodes[e + 1], nodes[e + 3]);
    }
    if (swapped < as_given)
      for (std::size_t e = 0; e < nodes.size(); e += 10) std::swap(nodes[e + 8], nodes[e + 9]);
  }

  // From its middle.
  double distance_to_edge(int node, int a, int b) const {
    const auto at = [this](int v, std::size_t axis) {
      return vertices_[3 * static_cast<std::size_t>(v) + axis];
    };
    double sum = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const double d = at(node, i) - (at(a, i) + at(b, i)) / 2;
      sum += d * d;
    }
    return std::sqrt(sum);
  }

  // To the next keyword.
  void skip_numbers() {
    while (!cursor_.empty() && !is_letter(cursor_.contents()[cursor_.position()])) cursor_.word();
  }

  InputCursor cursor_;
  ElementList elements_;
  int dimension_ = 0;
  bool has_vertices_ = false;
  std::vector<double> vertices_;
  std::vector<int> corners_;  // of the element being read
  std::vector<std::pair<const Section*, std::size_t>> postponed_;
};

}  // namespace

SurfaceMesh parse_medit_surface(std::string_view text, const std::string& name, const ReadOptions& options) {
  return surface_of(MeditReader(text, name, Wanted::surface, options).read());
}

TetMesh parse_medit_tets(std::string_view text, const std::string& name, const ReadOptions& options) {
  return tets_of(MeditReader(text, name, Wanted::tets, options).read());
}

ElementMesh parse_medit_elements(std::string_view text, const std::string& name, const ReadOptions& options) {
  return elements_of(MeditReader(text, name, Wanted::elements, options).read());
}

SurfaceMesh read_medit_surface(const std::string& path, const ReadOptions& options) {
  return parse_medit_surface(read_file(path), path, options);
}

TetMesh read_medit_tets(const std::string& path, const ReadOptions& options) {
  return parse_medit_tets(read_file(path), path, options);
}

}  // namespace isostretch::mesh
