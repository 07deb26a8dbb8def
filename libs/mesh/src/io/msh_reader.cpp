#include "file.hpp"
#include "msh_elements.hpp"
#include "number.hpp"
#include "source.hpp"
#include "tag_map.hpp"

#include <isostretch/mesh/io.hpp>

#include <utility>

namespace isostretch::mesh {
namespace {

constexpr Scalar size_type = Scalar::uint64;  // counts of version 4

class MshReader {
 public:
  MshReader(std::string_view contents, const std::string& name, Shape wanted, const ReadOptions& options)
      : source_(contents, name), elements_(wanted, options) {}

  MixedMesh read() {
    format();
    while (!source_.empty()) section();
    if (elements_.empty()) source_.fail(elements_.missing());
    return {std::move(vertices_), std::move(elements_)};
  }

 private:
  void format() {
    if (source_.word() != "$MeshFormat") source_.fail("not an MSH file: it does not begin with $MeshFormat");
    version();
    const std::int64_t type = source_.text_integer("file type");
    if (type != 0 && type != 1) source_.fail("file type " + std::to_string(type) + " is neither 0 nor 1");
    if (source_.text_integer("data size") != 8) source_.fail("data size is not 8");
    if (type == 1) byte_order();
    expect("$EndMeshFormat");
  }

  void version() {
    const std::string_view given = source_.word();
    if (given == "2" || given == "2.0" || given == "2.1" || given == "2.2")
      version_ = MshVersion::v2_2;
    else if (given == "4" || given == "4.0")
      version_ = MshVersion::v4_0;
    else if (given == "4.1")
      version_ = MshVersion::v4_1;
    else
      source_.fail("version " + quoted(given) + " is none of 2.0 to 2.2, 4.0 and 4.1");
  }

  // A one in the byte order of the file.
  void byte_order() {
    source_.line();
    source_.set_coding(Coding::little_endian);
    const std::size_t start = source_.position();
    if (source_.integer(Scalar::int32, "number 1") == 1) return;
    source_.seek(start);
    source_.set_coding(Coding::big_endian);
    if (source_.integer(Scalar::int32, "number 1") != 1) source_.fail("a number 1 should follow the format");
  }

  void section() {
    const std::string_view keyword = source_.word();
    if (keyword.size() < 2 || keyword.front() != '$')
      source_.fail("section expected, not " + quoted(keyword));
    if (keyword == "$Nodes")
      nodes();
    else if (keyword == "$Elements")
      elements();
    else
      skip_section(keyword);
  }

  // The end of the section is looked for: what it holds need not be known.
  void skip_section(std::string_view keyword) {
    const std::string end = "$End" + std::string(keyword.substr(1));
    const std::size_t found = source_.contents().find(end, source_.position());
    if (found == std::string_view::npos) source_.fail("section " + quoted(keyword) + " does not end");
    source_.seek(found + end.size());
  }

  void expect(const char* keyword) {
    const std::string_view found = source_.word();
    if (found != keyword)
      source_.fail(found.empty() ? std::string("the file ends where ") + keyword + " should be"
                                 : std::string(keyword) + " expected, not " + quoted(found));
  }

  void nodes() {
    if (has_elements_) source_.fail("nodes after elements");
    if (version_ == MshVersion::v2_2)
      nodes_in_one();
    else
      nodes_in_blocks();
    expect("$EndNodes");
    if (tags_.size() > static_cast<std::size_t>(largest_count)) source_.fail("too many nodes");
  }

  Scalar tag_type() const { return version_ == MshVersion::v4_1 ? size_type : Scalar::int32; }

  // Of a tag and a point.
  std::size_t node_size() const { return source_.binary() ? size_of(tag_type()) + 3 * sizeof(double) : 8; }

  void nodes_in_one() {
    const int count = source_.text_count("number of nodes", node_size());
    source_.line();
    source_.set_by_line(true);
    for (int i = 0; i < count; ++i) {
      source_.next_line();
      tags_.add(source_.integer(tag_type(), "node"));
      point();
    }
    leave_lines();
  }

  void nodes_in_blocks() {
    source_.line();
    const int blocks = source_.count(size_type, "number of blocks", 8);
    const int total = source_.count(size_type, "number of nodes", node_size());
    if (version_ == MshVersion::v4_1) skip_tag_range();
    const std::size_t before = tags_.size();
    for (int b = 0; b < blocks; ++b) node_block();
    const std::size_t found = tags_.size() - before;
    if (found != static_cast<std::size_t>(total))
      source_.fail(std::to_string(found) + " nodes instead of " + std::to_string(total));
  }

  void skip_tag_range() {
    source_.integer(size_type, "smallest tag");
    source_.integer(size_type, "largest tag");
  }

  // Dimension of the entity; the versions have it and the entity's tag in different order.
  std::int64_t entity() {
    const std::int64_t first = source_.integer(Scalar::int32, "entity");
    const std::int64_t second = source_.integer(Scalar::int32, "entity");
    return version_ == MshVersion::v4_1 ? first : second;
  }

  void node_block() {
    const std::int64_t dimension = entity();
    if (dimension < 0 || dimension > 3) source_.fail("entity of dimension " + std::to_string(dimension));
    const bool parametric = source_.integer(Scalar::int32, "parametric") != 0;
    const int count = source_.count(size_type, "number of nodes", node_size());
    const std::size_t parameters = parametric ? static_cast<std::size_t>(dimension) : 0;
    if (version_ == MshVersion::v4_1)
      for (int i = 0; i < count; ++i) tags_.add(source_.integer(size_type, "node"));
    source_.set_by_line(true);
    for (int i = 0; i < count; ++i) {
      source_.next_line();
      if (version_ == MshVersion::v4_0) tags_.add(source_.integer(tag_type(), "node"));
      point();
      if (source_.binary()) source_.bytes(parameters * sizeof(double), "parameters of the node");
    }
    leave_lines();
  }

  // What the last line holds beyond the numbers of interest is dropped with it.
  void leave_lines() {
    source_.next_line();
    source_.set_by_line(false);
  }

  void point() {
    for (const char* axis : axis_labels) vertices_.push_back(source_.coordinate(Scalar::float64, axis));
  }

  // Sections may be repeated; nodes come first.
  void elements() {
    if (tags_.size() == 0) source_.fail("elements before nodes");
    if (!has_elements_) prepare_tags();
    has_elements_ = true;
    if (version_ != MshVersion::v2_2)
      elements_in_blocks();
    else if (source_.binary())
      elements_in_runs();
    else
      elements_in_lines();
    expect("$EndElements");
  }

  void prepare_tags() {
    const int repeated = tags_.prepare();
    if (repeated >= 0) source_.fail("node " + std::to_string(tags_.tag(repeated)) + " for the second time");
  }

  // Version 2 in text: tag, type, number of tags, tags, nodes.
  void elements_in_lines() {
    const int count = source_.text_count("number of elements", 8);
    source_.set_by_line(true);
    for (int e = 0; e < count; ++e) {
      source_.next_line();
      source_.text_integer("element");
      const std::int64_t type = source_.text_integer("type");
      skip_tags();
      element(type, Scalar::int32);
    }
    leave_lines();
  }

  void skip_tags() {
    for (int t = source_.text_count("number of tags", 2); t > 0; --t) source_.text_integer("tag");
  }

  // Version 2 in binary: runs of elements of one type and one number of tags.
  void elements_in_runs() {
    const int total = source_.text_count("number of elements", sizeof(std::int32_t));
    source_.line();
    for (int done = 0; done < total;) {
      const std::int64_t type = source_.integer(Scalar::int32, "type");
      const std::int64_t count = source_.integer(Scalar::int32, "number of elements");
      const int tags = source_.count(Scalar::int32, "number of tags", sizeof(std::int32_t));
      if (count < 1 || count > total - done)
        source_.fail(std::to_string(count) + " elements where " + std::to_string(total - done) + " are left");
      binary_elements(type, static_cast<int>(count), 1 + static_cast<std::size_t>(tags), Scalar::int32);
      done += static_cast<int>(count);
    }
  }

  void elements_in_blocks() {
    source_.line();
    const int blocks = source_.count(size_type, "number of blocks", 8);
    const std::int64_t total = source_.integer(size_type, "number of elements");
    if (version_ == MshVersion::v4_1) skip_tag_range();
    std::int64_t done = 0;
    for (int b = 0; b < blocks; ++b) done += element_block();
    if (done != total) source_.fail(std::to_string(done) + " elements instead of " + std::to_string(total));
  }

  std::int64_t element_block() {
    entity();
    const std::int64_t type = source_.integer(Scalar::int32, "type");
    const int count =
        source_.count(size_type, "number of elements", source_.binary() ? size_of(tag_type()) : 4);
    if (source_.binary())
      binary_elements(type, count, 1, tag_type());
    else
      text_elements(type, count);
    return count;
  }

  void text_elements(std::int64_t type, int count) {
    source_.set_by_line(true);
    for (int e = 0; e < count; ++e) {
      source_.next_line();
      source_.text_integer("element");
      element(type, tag_type());
    }
    leave_lines();
  }

  // `before`: numbers in front of the nodes of each.
  void binary_elements(std::int64_t type, int count, std::size_t before, Scalar number) {
    const int nodes = msh_node_count(type);
    if (nodes == 0) source_.fail("elements of unknown type " + std::to_string(type));
    const std::size_t size = size_of(number) * (before + static_cast<std::size_t>(nodes));
    if (static_cast<std::size_t>(count) > source_.left() / size)
      source_.fail("the file ends within the elements");
    if (!elements_.wants(msh_shape(type))) {
      source_.bytes(size * static_cast<std::size_t>(count), "elements");
      elements_.skip(msh_shape(type), count);
      return;
    }
    for (int e = 0; e < count; ++e) {
      source_.bytes(size_of(number) * before, "element");
      element(type, number);
    }
  }

  // In text the rest of a line that is of no interest is dropped by next_line().
  void element(std::int64_t type, Scalar number) {
    const Shape shape = msh_shape(type);
    if (!elements_.wants(shape)) {
      elements_.skip(shape);
      return;
    }
    const int count = msh_node_count(type);
    if (const std::string fault = elements_.fault(count); !fault.empty()) source_.fail(fault);
    corners_.clear();
    for (int c = 0; c < count; ++c) corners_.push_back(node(number));
    elements_.add(corners_);
  }

  int node(Scalar number) {
    const std::int64_t tag = source_.integer(number, "node");
    const int position = tags_.find(tag);
    if (position < 0) source_.fail("node " + std::to_string(tag) + " is not in the file");
    return position;
  }

  Source source_;
  ElementList elements_;
  MshVersion version_ = MshVersion::v4_1;
  bool has_elements_ = false;
  TagMap tags_;
  std::vector<double> vertices_;
  std::vector<int> corners_;  // of the element being read
};

}  // namespace

SurfaceMesh parse_msh_surface(std::string_view contents, const std::string& name,
                              const ReadOptions& options) {
  return surface_of(MshReader(contents, name, Shape::face, options).read());
}

TetMesh parse_msh_tets(std::string_view contents, const std::string& name, const ReadOptions& options) {
  return tets_of(MshReader(contents, name, Shape::tet, options).read());
}

SurfaceMesh read_msh_surface(const std::string& path, const ReadOptions& options) {
  return parse_msh_surface(read_file(path), path, options);
}

TetMesh read_msh_tets(const std::string& path, const ReadOptions& options) {
  return parse_msh_tets(read_file(path), path, options);
}

}  // namespace isostretch::mesh
