#include "common/body.hpp"

#include "common/exit_code.hpp"
#include "common/figures/edges.hpp"
#include "common/fingerprint.hpp"
#include "common/formatted.hpp"
#include "common/terminal.hpp"

#include <isostretch/mesh/elements.hpp>
#include <isostretch/mesh/generators.hpp>
#include <isostretch/mesh/io.hpp>
#include <isostretch/mesh/quadratic.hpp>
#include <isostretch/mesh/repair.hpp>
#include <isostretch/mesh/structured.hpp>
#include <isostretch/mesh/weld.hpp>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace isostretch::app {
namespace {

using mesh::Shape;

constexpr Shape shapes[] = {Shape::triangle, Shape::quadratic_triangle, Shape::quad,
                            Shape::tet,      Shape::quadratic_tet,      Shape::hex};

std::string name_of(Shape shape) {
  std::string name = mesh::shape_name(shape);
  std::replace(name.begin(), name.end(), ' ', '_');
  return name;
}

// ---- what is seen ----

// Triangles among the nodes of a flat element.
const std::vector<std::array<int, 3>>& flat_triangles(Shape shape) {
  static const std::vector<std::array<int, 3>> whole{{0, 1, 2}}, halves{{0, 1, 2}, {0, 2, 3}},
      quarters{{0, 3, 5}, {3, 1, 4}, {5, 4, 2}, {3, 4, 5}};
  return shape == Shape::quad ? halves : shape == Shape::quadratic_triangle ? quarters : whole;
}

// All of a flat body; its nodes are the vertices.
template <class Elements>
mesh::BoundarySurface flat_surface(const mesh::Points3& nodes, const Elements& elements, Shape shape) {
  mesh::BoundarySurface surface;
  surface.mesh.vertices = nodes;
  surface.original_vertex.resize(static_cast<std::size_t>(nodes.rows()));
  std::iota(surface.original_vertex.begin(), surface.original_vertex.end(), 0);
  const auto& parts = flat_triangles(shape);
  surface.mesh.triangles.resize(elements.rows() * static_cast<Eigen::Index>(parts.size()), 3);
  Eigen::Index row = 0;
  for (Eigen::Index e = 0; e < elements.rows(); ++e)
    for (const auto& part : parts) {
      surface.mesh.triangles.row(row++) << elements(e, part[0]), elements(e, part[1]), elements(e, part[2]);
      surface.element.push_back(static_cast<int>(e));
    }
  return surface;
}

std::vector<std::array<int, 2>> boundary_edges(const Body& body) {
  const figures::Edges edges = figures::edges_of(body.surface.mesh.triangles);
  std::vector<std::array<int, 2>> result = edges.boundary;
  if (body.dim == 3) result.insert(result.end(), edges.inner.begin(), edges.inner.end());
  for (auto& edge : result)
    for (int& v : edge) v = body.surface.original_vertex[static_cast<std::size_t>(v)];
  return result;
}

Body finished(Body body, const mesh::ElementArrays& arrays) {
  body.dim = arrays.dim;
  body.elements = assembly::elements_from(arrays);
  body.boundary_edges = boundary_edges(body);
  return body;
}

// ---- kinds of bodies ----

// With the quadrature asked for.
template <class Mesh>
Body finished(Body body, const Mesh& m, const BodySpec& spec) {
  const int own = mesh::default_degree(body.shape), degree = spec.quadrature > 0 ? spec.quadrature : own;
  if (degree < own) body.richer = assembly::elements_from(mesh::elements(m, own));
  return finished(std::move(body), mesh::elements(m, degree));
}

void refuse_quadrature(const BodySpec& spec, const char* what) {
  if (spec.quadrature > 1)
    throw Error(std::string("quadrature: F is the same everywhere in a linear ") + what +
                ", one point is enough");
}

template <class Points>
mesh::Points3 in_space(const Points& flat) {
  mesh::Points3 points = mesh::Points3::Zero(flat.rows(), 3);
  points.leftCols(2) = flat.leftCols(2);
  return points;
}

Body quadratic_body(const mesh::QuadraticTriangleMesh& m, const BodySpec& spec) {
  Body body;
  body.shape = Shape::quadratic_triangle;
  body.nodes = in_space(m.nodes);
  body.surface = flat_surface(body.nodes, m.triangles, body.shape);
  return finished(std::move(body), m, spec);
}

Body triangle_body(const mesh::Points2& vertices, const mesh::Triangles& triangles, const BodySpec& spec) {
  if (spec.order == 2) return quadratic_body(mesh::quadratic(vertices, triangles), spec);
  Body body;
  refuse_quadrature(spec, "triangle");
  body.shape = Shape::triangle;
  body.nodes = in_space(vertices);
  body.surface = flat_surface(body.nodes, triangles, body.shape);
  return finished(std::move(body), mesh::elements(vertices, triangles));
}

Body triangle_body(const mesh::SurfaceMesh& flat, const BodySpec& spec) {
  return triangle_body(flat.vertices.leftCols<2>(), flat.triangles, spec);
}

Body quad_body(const mesh::QuadMesh& m, const BodySpec& spec) {
  Body body;
  body.shape = Shape::quad;
  body.nodes = in_space(m.vertices);
  body.surface = flat_surface(body.nodes, m.quads, body.shape);
  return finished(std::move(body), m, spec);
}

Body quadratic_body(const mesh::QuadraticTetMesh& m, const BodySpec& spec) {
  Body body;
  body.shape = Shape::quadratic_tet;
  body.nodes = m.nodes;
  body.surface = mesh::boundary_surface(m);
  return finished(std::move(body), m, spec);
}

Body tet_body(const mesh::TetMesh& tets, const BodySpec& spec) {
  if (spec.order == 2) return quadratic_body(mesh::quadratic(tets), spec);
  Body body;
  refuse_quadrature(spec, "tet");
  body.shape = Shape::tet;
  body.nodes = tets.vertices;
  const mesh::ElementArrays arrays = mesh::elements(tets);  // names what is wrong before anything else
  body.surface = mesh::boundary_surface(tets);
  return finished(std::move(body), arrays);
}

Body hex_body(const mesh::HexMesh& m, const BodySpec& spec) {
  Body body;
  body.shape = Shape::hex;
  body.nodes = m.vertices;
  body.surface = mesh::boundary_surface(m);
  return finished(std::move(body), m, spec);
}

Body make_bar(const BarSpec& bar, BodySpec spec) {
  if (bar.shape == Shape::quadratic_tet || bar.shape == Shape::quadratic_triangle) spec.order = 2;
  if (spec.order == 2 && (bar.shape == Shape::hex || bar.shape == Shape::quad))
    throw Error("order: only tets and triangles become quadratic, not " + name_of(bar.shape));
  const auto& n = bar.cells;
  const auto& s = bar.size;
  const auto dim = static_cast<std::size_t>(mesh::shape_dim(bar.shape));
  if (n.size() != dim || s.size() != dim)
    throw Error("a bar of element " + name_of(bar.shape) + " needs " + std::to_string(dim) +
                " cells and as many sizes");
  if (bar.shape == Shape::quad) return quad_body(mesh::quad_grid(n[0], n[1], s[0], s[1]), spec);
  if (bar.shape == Shape::hex) return hex_body(mesh::hex_bar(n[0], n[1], n[2], s[0], s[1], s[2]), spec);
  if (dim == 3) return tet_body(mesh::tet_bar(n[0], n[1], n[2], s[0], s[1], s[2]), spec);
  return triangle_body(mesh::grid(n[0], n[1], s[0], s[1]), spec);
}

struct Maker {
  const BodySpec& spec;

  Body operator()(const BarSpec& bar) const { return make_bar(bar, spec); }
  Body operator()(const GridSpec& g) const {
    const auto make = g.crossed ? mesh::crossed_grid : mesh::grid;
    return triangle_body(make(g.cells[0], g.cells[1], g.size[0], g.size[1]), spec);
  }
  Body operator()(const DiscSpec& disc) const { return triangle_body(mesh::disc(disc.rings), spec); }
  Body operator()(const BallSpec& ball) const { return tet_body(mesh::ball(ball.cells), spec); }
  Body operator()(const QuadrupedSpec& animal) const { return tet_body(mesh::quadruped(animal.cells), spec); }
};

constexpr const char* generated_names[] = {"bar", "grid", "disc", "ball", "quadruped"};

// ---- refinement ----

void multiply(int& cells, int factor) {
  if (cells > std::numeric_limits<int>::max() / factor)
    throw Error("refine: " + std::to_string(factor) + " times as many cells are too many");
  cells *= factor;
}

struct Multiplier {
  int factor;

  void operator()(BarSpec& bar) const {
    for (int& n : bar.cells) multiply(n, factor);
  }
  void operator()(GridSpec& grid) const {
    for (int& n : grid.cells) multiply(n, factor);
  }
  void operator()(DiscSpec& disc) const { multiply(disc.rings, factor); }
  void operator()(BallSpec& ball) const { multiply(ball.cells, factor); }
  void operator()(QuadrupedSpec& animal) const { multiply(animal.cells, factor); }
};

// ---- files ----

using mesh::ElementMesh;

// The vertices that belong to elements.
std::vector<bool> used_vertices(const ElementMesh& m) {
  std::vector<bool> used(static_cast<std::size_t>(m.vertices.rows()), false);
  for (Eigen::Index i = 0; i < m.elements.size(); ++i)
    used[static_cast<std::size_t>(m.elements.data()[i])] = true;
  return used;
}

Eigen::AlignedBox3d box_of(const mesh::Points3& vertices, const std::vector<bool>& used) {
  Eigen::AlignedBox3d box;
  for (Eigen::Index v = 0; v < vertices.rows(); ++v)
    if (used[static_cast<std::size_t>(v)]) box.extend(vertices.row(v).transpose());
  return box;
}

// Sum of the areas of all elements as vectors; that of the largest one where they cancel.
Eigen::Vector3d normal_of(const ElementMesh& m) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero(), largest = sum;
  double area = 0;
  for (Eigen::Index e = 0; e < m.elements.rows(); ++e) {
    const auto p = [&](int c) -> Eigen::Vector3d { return m.vertices.row(m.elements(e, c)); };
    const Eigen::Vector3d own =
        m.shape == Shape::quad ? (p(2) - p(0)).cross(p(3) - p(1)) : (p(1) - p(0)).cross(p(2) - p(0));
    sum += own;
    area += own.norm();
    if (own.norm() > largest.norm()) largest = own;
  }
  return (sum.norm() > 1e-3 * area ? sum : largest).stableNormalized();
}

// The plane with that normal: u is the first axis that is not nearly across, turned into the plane.
Plane plane_across(const Eigen::Vector3d& normal) {
  Plane plane;
  int axis = 0;
  while (std::abs(normal[axis]) > 0.9) ++axis;
  plane.u = (Eigen::Vector3d::Unit(axis) - normal[axis] * normal).normalized();
  plane.v = normal.cross(plane.u);
  return plane;
}

// Files of floats round to 1e-7 of their size.
constexpr double out_of_plane = 1e-6;

// Moves a surface from its plane to z = 0. Nothing but round-off may stand out of the plane.
std::optional<Plane> flatten(ElementMesh& m) {
  const std::vector<bool> used = used_vertices(m);
  const Eigen::AlignedBox3d box = box_of(m.vertices, used);
  const double tolerance = out_of_plane * box.diagonal().norm();
  if (box.sizes()[2] <= tolerance) {
    Plane plane;
    plane.origin[2] = box.min()[2] + (box.max()[2] - box.min()[2]) / 2;
    m.vertices.col(2).setZero();
    return plane.origin[2] == 0 ? std::nullopt : std::optional(plane);
  }
  const Eigen::Vector3d normal = normal_of(m);
  Plane plane = plane_across(normal);
  const auto first = static_cast<Eigen::Index>(std::find(used.begin(), used.end(), true) - used.begin());
  plane.origin = normal * normal.dot(m.vertices.row(first));
  for (Eigen::Index v = 0; v < m.vertices.rows(); ++v) {
    const Eigen::Vector3d p = m.vertices.row(v);
    const double height = normal.dot(p - plane.origin);
    if (used[static_cast<std::size_t>(v)] && !(std::abs(height) <= tolerance))
      throw Error("a surface is deformed in its plane, but vertex " + std::to_string(v) +
                  formatted(" stands %g out of that through vertex %td", height, first));
    m.vertices.row(v) << plane.u.dot(p - plane.origin), plane.v.dot(p - plane.origin), 0;
  }
  return plane;
}

std::string listed_elements(const std::vector<int>& elements) {
  constexpr std::size_t most = 10;
  std::string text;
  for (std::size_t i = 0; i < std::min(most, elements.size()); ++i)
    text += (i > 0 ? ", " : "") + std::to_string(elements[i]);
  return text + (elements.size() > most ? ", ..." : "");
}

std::string counted(const std::vector<int>& elements, Shape shape) {
  return std::to_string(elements.size()) + " " +
         (elements.size() == 1 ? mesh::shape_name(shape) : plural_name(shape));
}

std::string element_text(const ElementMesh& m, int e) {
  std::string text = std::string(mesh::shape_name(m.shape)) + " " + std::to_string(e) + " (vertices";
  for (Eigen::Index c = 0; c < m.elements.cols(); ++c) text += " " + std::to_string(m.elements(e, c));
  return text + ")";
}

// Some programs number the corners of solid elements the other way round. One such element among others is a
// fault.
void mend(ElementMesh& m, const MeshRepair& repair, const std::string& file) {
  const mesh::ElementRepairReport faults = mesh::find_faults(m);
  const bool solid = mesh::shape_dim(m.shape) == 3;
  const bool all_inverted = solid && std::ssize(faults.inverted) == m.elements.rows();
  const std::string hint = repair.offered ? "; --repair " : "";
  if (!repair.repair && !faults.duplicates.empty())
    throw Error(element_text(m, faults.duplicates[0]) + " is there twice" +
                (repair.offered ? hint + "leaves out copies" : ""));
  if (!repair.repair && !all_inverted && !faults.inverted.empty())
    throw Error(element_text(m, faults.inverted[0]) +
                (solid ? " has negative volume" : " has negative area") +
                ": it is numbered the other way round, or inverted" +
                (repair.offered ? hint + "turns such elements" : ""));
  if (faults.clean()) return;
  mesh::repair(m);
  if (all_inverted)
    notice(file + ": every " + mesh::shape_name(m.shape) +
           " is numbered the other way round; all were turned");
  else if (!faults.inverted.empty())
    notice(file + ": repair: " + counted(faults.inverted, m.shape) +
           " turned: " + listed_elements(faults.inverted));
  if (!faults.duplicates.empty())
    notice(file + ": repair: " + counted(faults.duplicates, m.shape) +
           " there twice, left out: " + listed_elements(faults.duplicates));
}

Body body_of(const ElementMesh& m, const BodySpec& spec) {
  const bool linear = m.shape == Shape::tet || m.shape == Shape::triangle;
  const bool quadratic = m.shape == Shape::quadratic_tet || m.shape == Shape::quadratic_triangle;
  if (spec.order == 2 && !linear && !quadratic)
    throw Error("order: only tets and triangles become quadratic, not " + plural_name(m.shape));
  const mesh::Points2 flat = m.vertices.leftCols<2>();
  switch (m.shape) {
    case Shape::triangle:
      return triangle_body(flat, m.elements, spec);
    case Shape::quadratic_triangle:
      return quadratic_body(mesh::QuadraticTriangleMesh{flat, m.elements}, spec);
    case Shape::quad:
      return quad_body({flat, m.elements}, spec);
    case Shape::tet:
      return tet_body({m.vertices, m.elements}, spec);
    case Shape::quadratic_tet:
      return quadratic_body(mesh::QuadraticTetMesh{m.vertices, m.elements}, spec);
    case Shape::hex:
      break;
  }
  return hex_body({m.vertices, m.elements}, spec);
}

Body read_body(const BodySpec& spec) {
  const std::string path = spec.file.string();
  ElementMesh m =
      mesh::read_elements(path, {.leave_out_faces = spec.repair.repair,
                                 .face_advice = spec.repair.offered ? "; --repair leaves it out" : ""});
  return naming_file(spec.file, [&] {
    if (spec.repair.weld)
      if (const int welded = mesh::weld(m, *spec.repair.weld); welded > 0)
        notice(path + ": " + std::to_string(welded) + " vertices welded to others");
    std::optional<Plane> plane;
    if (mesh::shape_dim(m.shape) == 2) plane = flatten(m);
    mend(m, spec.repair, path);
    Body body = body_of(m, spec);
    body.plane = plane;
    body.groups = std::move(m.groups);
    return body;
  });
}

}  // namespace

GeneratedBody refined(GeneratedBody body, int factor) {
  std::visit(Multiplier{factor}, body);
  return body;
}

Body load_body(const BodySpec& spec) {
  if (spec.generated) {
    Body body = std::visit(Maker{spec}, *spec.generated);
    body.name = generated_names[spec.generated->index()];
    return body;
  }
  Body body = read_body(spec);
  body.name = spec.file.filename().string();
  return body;
}

Vector Body::rest_positions() const {
  Vector x(nodes.rows() * dim);
  for (Eigen::Index n = 0; n < nodes.rows(); ++n)
    for (int i = 0; i < dim; ++i) x[dim * n + i] = nodes(n, i);
  return x;
}

mesh::Points3 Body::points(const Vector& positions) const {
  mesh::Points3 result = mesh::Points3::Zero(nodes.rows(), 3);
  for (Eigen::Index n = 0; n < nodes.rows(); ++n)
    for (int i = 0; i < dim; ++i) result(n, i) = positions[dim * n + i];
  return result;
}

mesh::Points3 Body::placed(const mesh::Points3& points) const {
  if (!plane) return points;
  mesh::Points3 result(points.rows(), 3);
  for (Eigen::Index n = 0; n < points.rows(); ++n)
    result.row(n) = (plane->origin + points(n, 0) * plane->u + points(n, 1) * plane->v).transpose();
  return result;
}

handles::Nodes Body::selectable() const {
  handles::Nodes result;
  result.dim = dim;
  result.positions = rest_positions();
  result.in_elements = in_elements();
  for (const mesh::ElementGroup& group : groups) {
    handles::NodeGroup own{group.number, group.name, group.vertices};
    const auto k = static_cast<std::size_t>(elements.nodes_per_element);
    for (const int e : group.elements) {
      const auto first =
          elements.nodes.begin() + static_cast<std::ptrdiff_t>(k * static_cast<std::size_t>(e));
      own.nodes.insert(own.nodes.end(), first, first + static_cast<std::ptrdiff_t>(k));
    }
    result.groups.push_back(std::move(own));
  }
  result.boundary_edges = boundary_edges;
  return result;
}

std::vector<bool> Body::in_elements() const {
  std::vector<bool> used(static_cast<std::size_t>(nodes.rows()), false);
  for (const int node : elements.nodes) used[static_cast<std::size_t>(node)] = true;
  return used;
}

double Body::diagonal() const {
  return box_of(nodes, in_elements()).diagonal().norm();
}

double Body::volume() const {
  return std::accumulate(elements.weights.begin(), elements.weights.end(), 0.0);
}

std::vector<double> Body::volumes() const {
  const auto points = static_cast<std::size_t>(elements.points_per_element);
  std::vector<double> result(static_cast<std::size_t>(elements.element_count()), 0.0);
  for (std::size_t i = 0; i < elements.weights.size(); ++i) result[i / points] += elements.weights[i];
  return result;
}

std::string Body::element_text(int element) const {
  const auto k = static_cast<std::size_t>(elements.nodes_per_element);
  std::string text = std::string(mesh::shape_name(shape)) + " " + std::to_string(element) + " (vertices";
  for (std::size_t c = 0; c < k; ++c)
    text.append(" ").append(std::to_string(elements.nodes[static_cast<std::size_t>(element) * k + c]));
  return text + ")";
}

std::string Body::fingerprint() const {
  Fingerprint fingerprint;
  fingerprint.add(nodes);
  fingerprint.add(elements.nodes);
  return fingerprint.text();
}

std::string plural_name(mesh::Shape shape) {
  return std::string(mesh::shape_name(shape)) + (shape == Shape::hex ? "es" : "s");
}

std::vector<std::string> shape_names() {
  std::vector<std::string> names;
  for (const Shape shape : shapes) names.push_back(name_of(shape));
  return names;
}

mesh::Shape shape_from_name(const std::string& name) {
  return *std::find_if(std::begin(shapes), std::end(shapes),
                       [&](Shape shape) { return name_of(shape) == name; });
}

}  // namespace isostretch::app
