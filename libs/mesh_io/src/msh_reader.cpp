#include "characters.hpp"
#include "file.hpp"
#include "input_cursor.hpp"
#include "msh_elements.hpp"
#include "msh_header.hpp"
#include "number.hpp"
#include "tag_map.hpp"

#include <isostretch/mesh_io/io.hpp>

#include <array>
#include <cstdlib>
#include <map>
#include <utility>

namespace isostretch::mesh {
namespace {

constexpr Scalar size_type = Scalar::uint64;  // counts of version 4

class MshReader {
 public:
  MshReader(std::string_view contents, const std::string& name, Wanted wanted, const ReadOptions& options)
      : cursor_(contents, name), elements_(wanted, options) {}

  MixedMesh read() {
    version_ = read_msh_header(cursor_);
    if (version_ == MshVersion::v2_2) elements_.merge_copies_of_groups();
    while (!cursor_.empty()) section();
    return {std::move(vertices_), std::move(elements_), cursor_.place()};
  }

 private:
  void section() {
    const std::string_view keyword = cursor_.word();
    if (keyword.size() < 2 || keyword.front() != '$')
      cursor_.fail("section expected, not " + quoted(keyword));
    if (keyword == "$Nodes")
      nodes();
    else if (keyword == "$Elements")
      elements();
    else if (keyword == "$PhysicalNames")
      physical_names();
    else if (keyword == "$Entities" && version_ != MshVersion::v2_2)
      entities();
    else if (keyword == "$PartitionedEntities" && version_ != MshVersion::v2_2)
      partitioned_entities();
    else
      skip_section(keyword);
  }

  // The end of the section is looked for: what it holds need not be known.
  void skip_section(std::string_view keyword) {
    const std::string end = "$End" + std::string(keyword.substr(1));
    const std::size_t found = cursor_.contents().find(end, cursor_.position());
    if (found == std::string_view::npos) cursor_.fail("section " + quoted(keyword) + " does not end");
    cursor_.seek(found + end.size());
  }

  // Text in binary files too: dimension, number, name in quotes.
  void physical_names() {
    for (int i = cursor_.text_count("number of names", 6); i > 0; --i) {
      const std::int64_t dimension = cursor_.text_integer("dimension");
      const std::int64_t number = cursor_.text_integer("number of a physical group");
      std::string_view name = trimmed(cursor_.line());
      if (name.size() < 2 || name.front() != '"' || name.back() != '"')
        cursor_.fail("name of a physical group is not in quotes");
      elements_.name_group(static_cast<int>(dimension), number, name.substr(1, name.size() - 2));
    }
    expect("$EndPhysicalNames");
  }

  // In which physical groups points, curves, surfaces and volumes are.
  void entities() {
    cursor_.line();
    all_entities(false);
    expect("$EndEntities");
  }

  // Parts of the others, of which elements are once the mesh is partitioned; with groups of their own.
  void partitioned_entities() {
    cursor_.line();
    cursor_.integer(size_type, "number of partitions");
    for (int i = cursor_.count(size_type, "number of ghost entities", 4); i > 0; --i)
      skip_integers(2, "ghost entity");
    all_entities(true);
    expect("$EndPartitionedEntities");
  }

  void all_entities(bool partitioned) {
    std::array<int, 4> counts{};
    for (int& count : counts) count = cursor_.count(size_type, "number of entities", 4);
    for (std::size_t dimension = 0; dimension < counts.size(); ++dimension)
      for (int i = 0; i < counts[dimension]; ++i) one_entity(static_cast<int>(dimension), partitioned);
  }

  void one_entity(int dimension, bool partitioned) {
    const std::int64_t tag = cursor_.integer(Scalar::int32, "entity");
    if (partitioned) {
      skip_integers(2, "entity that this one is part of");
      skip_integers(cursor_.count(size_type, "number of partitions", sizeof(std::int32_t)), "partition");
    }
    const int place = dimension == 0 && version_ == MshVersion::v4_1 ? 3 : 6;  // a point, or a box
    for (int i = 0; i < place; ++i) skip_number();
    auto& groups = groups_of_entity_[{dimension, tag}];
    for (int i = cursor_.count(size_type, "number of physical groups", sizeof(std::int32_t)); i > 0; --i)
      groups.push_back(std::abs(cursor_.integer(Scalar::int32, "physical group")));  // a sign is a direction
    if (dimension == 0) return;
    skip_integers(cursor_.count(size_type, "number of bounding entities", sizeof(std::int32_t)),
                  "bounding entity");
  }

  void skip_integers(int count, const char* what) {
    for (; count > 0; --count) cursor_.integer(Scalar::int32, what);
  }

  // Of a box that is empty, whose numbers need not be finite.
  void skip_number() {
    if (cursor_.binary())
      cursor_.bytes(sizeof(double), "box of an entity");
    else if (cursor_.word().empty())
      cursor_.fail("the file ends within an entity");
  }

  void expect(const char* keyword) { expect_word(cursor_, keyword); }

  void nodes() {
    if (has_elements_) cursor_.fail("nodes after elements");
    if (version_ == MshVersion::v2_2)
      nodes_in_one();
    else
      nodes_in_blocks();
    expect("$EndNodes");
    if (tags_.size() > static_cast<std::size_t>(largest_count)) cursor_.fail("too many nodes");
  }

  Scalar tag_type() const { return version_ == MshVersion::v4_1 ? size_type : Scalar::int32; }

  // Of a tag and a point.
  std::size_t node_size() const { return cursor_.binary() ? size_of(tag_type()) + 3 * sizeof(double) : 8; }

  void nodes_in_one() {
    const int count = cursor_.text_count("number of nodes", node_size());
    cursor_.line();
    cursor_.set_by_line(true);
    for (int i = 0; i < count; ++i) {
      cursor_.next_line();
      tags_.add(cursor_.integer(tag_type(), "node"));
      point();
    }
    leave_lines();
  }

  void nodes_in_blocks() {
    cursor_.line();
    const int blocks = cursor_.count(size_type, "number of blocks", 8);
    const int total = cursor_.count(size_type, "number of nodes", node_size());
    if (version_ == MshVersion::v4_1) skip_tag_range();
    const std::size_t before = tags_.size();
    for (int b = 0; b < blocks; ++b) node_block();
    const std::size_t found = tags_.size() - before;
    if (found != static_cast<std::size_t>(total))
      cursor_.fail(std::to_string(found) + " nodes instead of " + std::to_string(total));
  }

  void skip_tag_range() {
    cursor_.integer(size_type, "smallest tag");
    cursor_.integer(size_type, "largest tag");
  }

  // Dimension and tag of an entity; the versions have them in different order.
  std::pair<int, std::int64_t> entity() {
    const std::int64_t first = cursor_.integer(Scalar::int32, "entity");
    const std::int64_t second = cursor_.integer(Scalar::int32, "entity");
    const bool dimension_first = version_ == MshVersion::v4_1;
    const std::int64_t dimension = dimension_first ? first : second;
    if (dimension < 0 || dimension > 3) cursor_.fail("entity of dimension " + std::to_string(dimension));
    return {static_cast<int>(dimension), dimension_first ? second : first};
  }

  void node_block() {
    const int dimension = entity().first;
    const bool parametric = cursor_.integer(Scalar::int32, "parametric") != 0;
    const int count = cursor_.count(size_type, "number of nodes", node_size());
    const std::size_t parameters = parametric ? static_cast<std::size_t>(dimension) : 0;
    if (version_ == MshVersion::v4_1)
      for (int i = 0; i < count; ++i) tags_.add(cursor_.integer(size_type, "node"));
    cursor_.set_by_line(true);
    for (int i = 0; i < count; ++i) {
      cursor_.next_line();
      if (version_ == MshVersion::v4_0) tags_.add(cursor_.integer(tag_type(), "node"));
      point();
      if (cursor_.binary()) cursor_.bytes(parameters * sizeof(double), "parameters of the node");
    }
    leave_lines();
  }

  // What the last line holds beyond the numbers of interest is dropped with it.
  void leave_lines() {
    cursor_.next_line();
    cursor_.set_by_line(false);
  }

  void point() {
    for (const char* axis : axis_labels) vertices_.push_back(cursor_.coordinate(Scalar::float64, axis));
  }

  // Sections may be repeated; nodes come first.
  void elements() {
    if (tags_.size() == 0) cursor_.fail("elements before nodes");
    if (!has_elements_) prepare_tags();
    has_elements_ = true;
    if (version_ != MshVersion::v2_2)
      elements_in_blocks();
    else if (cursor_.binary())
      elements_in_runs();
    else
      elements_in_lines();
    expect("$EndElements");
  }

  void prepare_tags() {
    const int repeated = tags_.prepare();
    if (repeated >= 0) cursor_.fail("node " + std::to_string(tags_.tag(repeated)) + " for the second time");
  }

  // Version 2 in text: tag, type, number of tags, tags, nodes.
  void elements_in_lines() {
    const int count = cursor_.text_count("number of elements", 8);
    cursor_.set_by_line(true);
    for (int e = 0; e < count; ++e) {
      cursor_.next_line();
      label_.number = cursor_.text_integer("element");
      const CellKind kind = known_kind(cursor_.text_integer("type"));
      read_tags(cursor_.text_count("number of tags", 2));
      element(kind, Scalar::int32);
    }
    leave_lines();
  }

  // The first is that of a physical group, or 0, the second that of the entity.
  void read_tags(int count) {
    label_.groups.clear();
    label_.entity = 0;
    for (int t = 0; t < count; ++t) {
      const std::int64_t tag = cursor_.integer(Scalar::int32, "tag");
      if (t == 0 && tag != 0) label_.groups.push_back(std::abs(tag));
      if (t == 1) label_.entity = tag;
    }
  }

  // Version 2 in binary: runs of elements of one type and one number of tags.
  void elements_in_runs() {
    const int total = cursor_.text_count("number of elements", sizeof(std::int32_t));
    cursor_.line();
    for (int done = 0; done < total;) {
      const CellKind kind = known_kind(cursor_.integer(Scalar::int32, "type"));
      const std::int64_t count = cursor_.integer(Scalar::int32, "number of elements");
      const int tags = cursor_.count(Scalar::int32, "number of tags", sizeof(std::int32_t));
      if (count < 1 || count > total - done)
        cursor_.fail(std::to_string(count) + " elements where " + std::to_string(total - done) + " are left");
      if (!skip_unwanted(kind, static_cast<int>(count), 1 + tags, Scalar::int32))
        for (std::int64_t e = 0; e < count; ++e) {
          label_.number = cursor_.integer(Scalar::int32, "element");
          read_tags(tags);
          element(kind, Scalar::int32);
        }
      done += static_cast<int>(count);
    }
  }

  void elements_in_blocks() {
    cursor_.line();
    const int blocks = cursor_.count(size_type, "number of blocks", 8);
    const std::int64_t total = cursor_.integer(size_type, "number of elements");
    if (version_ == MshVersion::v4_1) skip_tag_range();
    std::int64_t done = 0;
    for (int b = 0; b < blocks; ++b) done += element_block();
    if (done != total) cursor_.fail(std::to_string(done) + " elements instead of " + std::to_string(total));
  }

  std::int64_t element_block() {
    const auto groups = groups_of_entity_.find(entity());
    label_.groups = groups == groups_of_entity_.end() ? std::vector<std::int64_t>() : groups->second;
    const CellKind kind = known_kind(cursor_.integer(Scalar::int32, "type"));
    const int count =
        cursor_.count(size_type, "number of elements", cursor_.binary() ? size_of(tag_type()) : 4);
    if (skip_unwanted(kind, count, 1, tag_type())) return count;
    cursor_.set_by_line(true);
    for (int e = 0; e < count; ++e) {
      cursor_.next_line();
      label_.number = cursor_.integer(tag_type(), "element");
      element(kind, tag_type());
    }
    leave_lines();
    return count;
  }

  CellKind known_kind(std::int64_t type) const {
    const CellKind kind = msh_kind(type);
    if (kind.nodes == 0) cursor_.fail("elements of unknown type " + std::to_string(type));
    return kind;
  }

  // In binary; `before`: numbers in front of the nodes of each.
  bool skip_unwanted(CellKind kind, int count, int before, Scalar number) {
    if (!cursor_.binary()) return false;
    const std::size_t size = size_of(number) * static_cast<std::size_t>(before + kind.nodes);
    if (static_cast<std::size_t>(count) > cursor_.left() / size)
      cursor_.fail("the file ends within the elements");
    if (elements_.wants(kind)) return false;
    cursor_.bytes(size * static_cast<std::size_t>(count), "elements");
    elements_.skip(kind, count);
    return true;
  }

  // In text the rest of a line that is of no interest is dropped by next_line().
  void element(CellKind kind, Scalar number) {
    if (!elements_.wants(kind)) {
      elements_.skip(kind);
      return;
    }
    const Place place = cursor_.place();
    corners_.clear();
    for (int c = 0; c < kind.nodes; ++c) corners_.push_back(node(number));
    if (kind == CellKind{Family::tet, 10}) std::swap(corners_[8], corners_[9]);  // to VTK's order
    elements_.add(kind, corners_, place, label_);
  }

  int node(Scalar number) {
    const std::int64_t tag = cursor_.integer(number, "node");
    const int position = tags_.find(tag);
    if (position < 0) cursor_.fail("node " + std::to_string(tag) + " is not in the file");
    return position;
  }

  InputCursor cursor_;
  ElementList elements_;
  MshVersion version_ = MshVersion::v4_1;
  bool has_elements_ = false;
  TagMap tags_;
  std::vector<double> vertices_;
  std::map<std::pair<int, std::int64_t>, std::vector<std::int64_t>> groups_of_entity_;
  ElementLabel label_;  // of the element being read
  std::vector<int> corners_;
};

}  // namespace

SurfaceMesh parse_msh_surface(std::string_view contents, const std::string& name,
                              const ReadOptions& options) {
  return surface_of(MshReader(contents, name, Wanted::surface, options).read());
}

TetMesh parse_msh_tets(std::string_view contents, const std::string& name, const ReadOptions& options) {
  return tets_of(MshReader(contents, name, Wanted::tets, options).read());
}

ElementMesh parse_msh_elements(std::string_view contents, const std::string& name,
                               const ReadOptions& options) {
  return elements_of(MshReader(contents, name, Wanted::elements, options).read());
}

SurfaceMesh read_msh_surface(const std::string& path, const ReadOptions& options) {
  return parse_msh_surface(read_file(path), path, options);
}

TetMesh read_msh_tets(const std::string& path, const ReadOptions& options) {
  return parse_msh_tets(read_file(path), path, options);
}

}  // namespace isostretch::mesh
