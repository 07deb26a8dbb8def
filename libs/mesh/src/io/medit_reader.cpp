#include "elements.hpp"
#include "file.hpp"
#include "number.hpp"
#include "source.hpp"

#include <isostretch/mesh/io.hpp>

#include <utility>

namespace isostretch::mesh {
namespace {

struct Section {
  const char* keyword;  // in lower case: files differ in End and END
  Shape shape;
  int corners;
};
constexpr Section element_sections[] = {
    {"triangles", Shape::face, 3}, {"quadrilaterals", Shape::face, 4}, {"tetrahedra", Shape::tet, 4}};

bool is_letter(char c) {
  return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z');
}

class MeditReader {
 public:
  MeditReader(std::string_view text, const std::string& name, Shape wanted, const ReadOptions& options)
      : source_(text, name), elements_(wanted, options) {
    source_.set_comments(true);
  }

  MixedMesh read() {
    header();
    sections();
    for (const auto& [section, position] : postponed_) {
      source_.seek(position);
      read_elements(*section);
    }
    if (elements_.empty()) source_.fail(elements_.missing());
    return {std::move(vertices_), std::move(elements_)};
  }

 private:
  void header() {
    if (lower(source_.word()) != "meshversionformatted")
      source_.fail("not a MEDIT file: it does not begin with MeshVersionFormatted");
    source_.text_integer("version");
  }

  void sections() {
    for (std::string_view word = source_.word(); !word.empty(); word = source_.word()) {
      if (!is_letter(word.front())) source_.fail("keyword expected, not " + quoted(word));
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
    const std::int64_t given = source_.text_integer("dimension");
    if (given != 2 && given != 3) source_.fail("dimension " + std::to_string(given) + " is neither 2 nor 3");
    dimension_ = static_cast<int>(given);
  }

  void vertices() {
    if (dimension_ == 0) source_.fail("Vertices before Dimension");
    if (has_vertices_) source_.fail("Vertices for the second time");
    has_vertices_ = true;
    const int count = source_.text_count("number of vertices", 2 * static_cast<std::size_t>(dimension_ + 1));
    vertices_.assign(3 * static_cast<std::size_t>(count), 0.0);
    for (double* v = vertices_.data(); v < vertices_.data() + vertices_.size(); v += 3) {
      for (int a = 0; a < dimension_; ++a) v[a] = source_.text_coordinate(axis_labels[a]);
      reference();
    }
  }

  // Of no use here; some programs write it as a real number.
  void reference() {
    if (source_.word().empty()) source_.fail("missing reference");
  }

  // Elements may stand before the vertices that they name.
  void elements(const Section& section) {
    if (!has_vertices_) postponed_.emplace_back(&section, source_.position());
    if (!has_vertices_)
      skip_numbers();
    else
      read_elements(section);
  }

  void read_elements(const Section& section) {
    const int count =
        source_.text_count("number of elements", 2 * static_cast<std::size_t>(section.corners + 1));
    for (int e = 0; e < count; ++e) {
      if (elements_.wants(section.shape))
        element(section.corners);
      else
        skip_element(section);
    }
  }

  void element(int corners) {
    corners_.clear();
    for (int c = 0; c < corners; ++c)
      corners_.push_back(source_.index(Scalar::int32, "vertex index", 1, vertices_.size() / 3));
    if (const std::string fault = elements_.fault(corners); !fault.empty()) source_.fail(fault);
    elements_.add(corners_);
    reference();
  }

  void skip_element(const Section& section) {
    for (int c = 0; c <= section.corners; ++c)
      if (source_.word().empty()) source_.fail("the file ends within " + std::string(section.keyword));
    elements_.skip(section.shape);
  }

  // To the next keyword.
  void skip_numbers() {
    while (!source_.empty() && !is_letter(source_.contents()[source_.position()])) source_.word();
  }

  Source source_;
  ElementList elements_;
  int dimension_ = 0;
  bool has_vertices_ = false;
  std::vector<double> vertices_;
  std::vector<int> corners_;  // of the element being read
  std::vector<std::pair<const Section*, std::size_t>> postponed_;
};

}  // namespace

SurfaceMesh parse_medit_surface(std::string_view text, const std::string& name, const ReadOptions& options) {
  return surface_of(MeditReader(text, name, Shape::face, options).read());
}

TetMesh parse_medit_tets(std::string_view text, const std::string& name, const ReadOptions& options) {
  return tets_of(MeditReader(text, name, Shape::tet, options).read());
}

SurfaceMesh read_medit_surface(const std::string& path, const ReadOptions& options) {
  return parse_medit_surface(read_file(path), path, options);
}

TetMesh read_medit_tets(const std::string& path, const ReadOptions& options) {
  return parse_medit_tets(read_file(path), path, options);
}

}  // namespace isostretch::mesh
