#include "elements.hpp"

#include <algorithm>
#include <iterator>

namespace isostretch::mesh {
namespace {

struct FamilyFacts {
  const char* one;
  const char* many;
  int dimension;
  int nodes;  // of the linear element, 0: any
};

const FamilyFacts& facts(Family family) {
  static constexpr FamilyFacts table[] = {
      {"point", "points", 0, 1},           {"line", "lines", 1, 2},       {"triangle", "triangles", 2, 3},
      {"quadrangle", "quadrangles", 2, 4}, {"polygon", "polygons", 2, 0}, {"tetrahedron", "tetrahedra", 3, 4},
      {"hexahedron", "hexahedra", 3, 8},   {"prism", "prisms", 3, 6},     {"pyramid", "pyramids", 3, 5},
      {"polyhedron", "polyhedra", 3, 0}};
  return table[static_cast<std::size_t>(family)];
}

struct ShapeOfKind {
  CellKind kind;
  Shape shape;
};
constexpr ShapeOfKind shapes[] = {
    {{Family::triangle, 3}, Shape::triangle},  {{Family::triangle, 6}, Shape::quadratic_triangle},
    {{Family::quad, 4}, Shape::quad},          {{Family::tet, 4}, Shape::tet},
    {{Family::tet, 10}, Shape::quadratic_tet}, {{Family::hex, 8}, Shape::hex}};

// Polygons of three and four corners by their own names, all others as one kind.
CellKind normalized(CellKind kind) {
  if (kind.family != Family::polygon) return kind;
  if (kind.nodes == 3) return {Family::triangle, 3};
  if (kind.nodes == 4) return {Family::quad, 4};
  return {Family::polygon, 0};
}

const ShapeOfKind* find_shape(CellKind given) {
  const CellKind kind = normalized(given);
  const auto* const found =
      std::find_if(std::begin(shapes), std::end(shapes), [&](const auto& s) { return s.kind == kind; });
  return found == std::end(shapes) ? nullptr : found;
}

bool is_face(CellKind kind) {
  return kind.family == Family::polygon || (kind.family == Family::triangle && kind.nodes == 3) ||
         (kind.family == Family::quad && kind.nodes == 4);
}

int compare_rows(const int* a, const int* b, int count) {
  for (int i = 0; i < count; ++i)
    if (a[i] != b[i]) return a[i] < b[i] ? -1 : 1;
  return 0;
}

}  // namespace

int CellKind::dimension() const {
  return facts(family).dimension;
}

std::string counted(CellKind kind, long count) {
  const FamilyFacts& family = facts(kind.family);
  std::string text = std::to_string(count) + " " + (count == 1 ? family.one : family.many);
  if (family.nodes != 0 && kind.nodes != family.nodes && kind.nodes != 0)
    text += " of " + std::to_string(kind.nodes) + " nodes";
  return text;
}

bool ElementList::wants(CellKind kind) const {
  if (wanted_ == Wanted::surface) return is_face(kind);
  if (wanted_ == Wanted::tets) return kind == CellKind{Family::tet, 4};
  return find_shape(kind) != nullptr || (kind.dimension() < 2 && kind.nodes > 0);
}

void ElementList::add(CellKind kind, const std::vector<int>& nodes, const Place& place,
                      const ElementLabel& label) {
  skip(kind);
  if (wanted_ == Wanted::surface) {
    const std::size_t before = faces_.count();
    faces_.add(nodes, place);
    if (faces_.count() > before) face_labels_.add(label);
    return;
  }
  if (kind.dimension() < 2) {  // only for the groups they are in
    for (const std::int64_t group : label.groups) {
      std::vector<int>& vertices = lines_and_points_[{kind.dimension(), group}];
      vertices.insert(vertices.end(), nodes.begin(), nodes.end());
    }
    return;
  }
  List& list = lists_[static_cast<std::size_t>(find_shape(kind)->shape)];
  list.nodes.insert(list.nodes.end(), nodes.begin(), nodes.end());
  list.labels.add(label);
}

void ElementList::skip(CellKind kind, long count) {
  // Elements of a kind follow each other.
  if (!last_count_ || kind != last_kind_) last_kind_ = kind, last_count_ = &counts_[normalized(kind)];
  *last_count_ += count;
}

void ElementList::name_group(int dimension, std::int64_t number, std::string_view name) {
  group_names_[{dimension, number}] = name;
}

long ElementList::count(int dimension) const {
  long sum = 0;
  for (const auto& [kind, count] : counts_) sum += kind.dimension() == dimension ? count : 0;
  return sum;
}

// "1 hexahedron and 2 tetrahedra".
std::string ElementList::listed(int dimension) const {
  std::vector<std::string> parts;
  for (const auto& [kind, count] : counts_)
    if (kind.dimension() == dimension) parts.push_back(counted(kind, count));
  std::string text;
  for (std::size_t i = 0; i < parts.size(); ++i)
    text += (i == 0 ? "" : i + 1 == parts.size() ? " and " : ", ") + parts[i];
  return text;
}

std::string ElementList::missing_faces() const {
  if (count(3) > 0) return "no triangles: a mesh of " + listed(3) + ", to be read as such";
  if (count(2) > 0) return "no triangles, only " + listed(2);
  const long others = count(0) + count(1);
  return others > 0 ? "no triangles, only " + std::to_string(others) + " elements of other kinds"
                    : "no triangles";
}

SurfaceMesh ElementList::surface(const std::vector<double>& vertices, const std::vector<double>& uv,
                                 const Place& end) {
  if (faces_.empty()) end.fail(missing_faces());
  for (const auto& [kind, number] : counts_)
    if (kind.dimension() == 2 && !is_face(kind))
      end.fail(listed(2) + ": of a surface only flat faces are read");
  std::string fault;
  const auto compare = [this](int a, int b) {
    const auto x = static_cast<std::size_t>(a), y = static_cast<std::size_t>(b);
    if (faces_.size(x) != faces_.size(y)) return faces_.size(x) - faces_.size(y);
    return compare_rows(faces_.corners(x), faces_.corners(y), faces_.size(x));
  };
  const std::vector<char> keep = face_labels_.drop_copies(compare, copies_for_groups_, fault);
  if (!fault.empty()) end.fail(fault);
  if (std::find(keep.begin(), keep.end(), 0) != keep.end()) faces_.keep(keep);
  return with_uv(faces_.surface(vertices, {}, end), uv);
}

void ElementList::drop_copies(List& list, int nodes_each, const Place& end) const {
  const auto each = static_cast<std::size_t>(nodes_each);
  std::string fault;
  const auto compare = [&](int a, int b) {
    return compare_rows(list.nodes.data() + each * static_cast<std::size_t>(a),
                        list.nodes.data() + each * static_cast<std::size_t>(b), nodes_each);
  };
  const std::vector<char> keep = list.labels.drop_copies(compare, copies_for_groups_, fault);
  if (!fault.empty()) end.fail(fault);
  std::size_t kept = 0;
  for (std::size_t e = 0; e < keep.size(); ++e)
    if (keep[e])
      std::copy_n(list.nodes.begin() + static_cast<std::ptrdiff_t>(each * e), each,
                  list.nodes.begin() + static_cast<std::ptrdiff_t>(each * kept++));
  list.nodes.resize(each * kept);
}

// No solid element is dropped without a word.
void ElementList::require_one_kind(int dimension, const Place& end) const {
  int supported = 0, kinds = 0;
  const Shape* shape = nullptr;
  for (const auto& [kind, number] : counts_) {
    if (kind.dimension() != dimension || number == 0) continue;
    const ShapeOfKind* const found = find_shape(kind);
    if (!found || !shape || *shape != found->shape) ++kinds;
    if (found) ++supported, shape = &found->shape;
  }
  if (supported == 0) end.fail("only " + listed(dimension) + ", which are no elements of a body here");
  if (kinds > 1)
    end.fail(listed(dimension) +
             ": a body is of one kind of elements, triangles, quadrangles, "
             "tetrahedra (linear or of second order) or hexahedra");
}

TetMesh ElementList::tets(const std::vector<double>& vertices, const Place& end) {
  List& list = lists_[static_cast<std::size_t>(Shape::tet)];
  if (list.nodes.empty() && count(3) > 0) end.fail("no tetrahedra of 4 nodes, only " + listed(3));
  if (list.nodes.empty() && count(2) > 0)
    end.fail("no tetrahedra: a surface of " + std::to_string(count(2)) + " faces, to be read as such");
  if (list.nodes.empty()) {
    const long others = count(0) + count(1);
    end.fail(others > 0 ? "no tetrahedra, only " + std::to_string(others) + " elements of other kinds"
                        : "no tetrahedra");
  }
  require_one_kind(3, end);
  drop_copies(list, 4, end);
  return {to_rows<double, 3>(vertices), to_rows<int, 4>(list.nodes)};
}

std::string ElementList::group_name(int dimension, std::int64_t number) const {
  const auto name = group_names_.find({dimension, number});
  return name == group_names_.end() ? std::string() : name->second;
}

std::vector<ElementGroup> ElementList::groups_of(const List& list, int dimension) const {
  std::vector<ElementGroup> groups;
  for (const auto& [number, element] : list.labels.groups()) {
    if (groups.empty() || groups.back().number != number)
      groups.push_back({number, group_name(dimension, number), {}});
    groups.back().elements.push_back(element);
  }
  return groups;
}

// Of what is no element of a body of that dimension.
void ElementList::add_lower_groups(int dimension, std::vector<ElementGroup>& groups) const {
  auto vertices = lines_and_points_;
  for (const Shape shape : {Shape::triangle, Shape::quadratic_triangle, Shape::quad}) {
    const List& list = lists_[static_cast<std::size_t>(shape)];
    const int nodes = shape_node_count(shape);
    if (dimension == 3)
      for (const auto& [number, element] : list.labels.groups()) {
        const auto first = list.nodes.begin() + std::ptrdiff_t{nodes} * element;
        auto& own = vertices[{2, number}];
        own.insert(own.end(), first, first + nodes);
      }
  }
  for (int d = dimension - 1; d >= 0; --d)
    for (auto& [key, own] : vertices) {
      if (key.first != d) continue;
      std::sort(own.begin(), own.end());
      own.erase(std::unique(own.begin(), own.end()), own.end());
      groups.push_back({key.second, group_name(d, key.second), {}, std::move(own)});
    }
}

ElementMesh ElementList::elements(const std::vector<double>& vertices, const Place& end) {
  const int dimension = count(3) > 0 ? 3 : 2;
  if (count(dimension) == 0) end.fail("no elements of a body: neither solid ones nor faces");
  require_one_kind(dimension, end);
  const auto found = std::find_if(lists_.begin(), lists_.end(), [&](const List& list) {
    const auto shape = static_cast<Shape>(&list - lists_.data());
    return shape_dim(shape) == dimension && !list.nodes.empty();
  });
  ElementMesh mesh;
  mesh.shape = static_cast<Shape>(found - lists_.begin());
  const int nodes = shape_node_count(mesh.shape);
  drop_copies(*found, nodes, end);
  mesh.vertices = to_rows<double, 3>(vertices);
  mesh.elements = Eigen::Map<const decltype(mesh.elements)>(
      found->nodes.data(), static_cast<Eigen::Index>(found->nodes.size()) / nodes, nodes);
  mesh.groups = groups_of(*found, dimension);
  add_lower_groups(dimension, mesh.groups);
  return mesh;
}

}  // namespace isostretch::mesh
