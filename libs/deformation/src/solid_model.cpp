
#include <isostretch/core/error.hpp>
#include <isostretch/core/log.hpp>
#include <isostretch/core/text.hpp>
#include <isostretch/deformation/fingerprint.hpp>
#include <isostretch/deformation/solid_model.hpp>
#include <isostretch/deformation/solid_model_file.hpp>
#include <isostretch/fem/elements.hpp>
#include <isostretch/fem/quadratic.hpp>
#include <isostretch/mesh/generators.hpp>
#include <isostretch/mesh/structured.hpp>
#include <isostretch/surface/edges.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace isostretch::deformation {
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

std::vector<std::array<int, 2>> boundary_edges(const SolidModel& body) {
  const mesh::Edges edges = mesh::edges_of(body.surface.mesh.triangles);
  std::vector<std::array<int, 2>> result = edges.boundary;
  if (body.dim == 3) result.insert(result.end(), edges.inner.begin(), edges.inner.end());
  for (auto& edge : result)
    for (int& v : edge) v = body.surface.original_vertex[static_cast<std::size_t>(v)];
  return result;
}

SolidModel finished(SolidModel body, const mesh::ElementArrays& arrays) {
  body.dim = arrays.dim;
  body.elements = assembly::elements_from(arrays);
  body.boundary_edges = boundary_edges(body);
  return body;
}

// ---- kinds of bodies ----

// With the quadrature asked for.
template <class Mesh>
SolidModel finished(SolidModel body, const Mesh& m, const SolidSpec& spec) {
  const int own = mesh::default_degree(body.shape), degree = spec.quadrature > 0 ? spec.quadrature : own;
  if (degree < own) body.richer = assembly::elements_from(mesh::elements(m, own));
  return finished(std::move(body), mesh::elements(m, degree));
}

void refuse_quadrature(const SolidSpec& spec, const char* what) {
  if (spec.quadrature > 1)
    throw Error(std::string("quadrature: F is the same everywhere in a linear ") + what +
                ", one point is enough");
}

mesh::Points3 in_space(const mesh::Points2& flat) {
  mesh::Points3 points = mesh::Points3::Zero(flat.rows(), 3);
  points.leftCols(2) = flat.leftCols(2);
  return points;
}

template <class Elements>
SolidModel flat_body(Shape shape, const mesh::Points2& nodes, const Elements& elements) {
  SolidModel body;
  body.shape = shape;
  body.nodes = in_space(nodes);
  body.surface = flat_surface(body.nodes, elements, shape);
  return body;
}

SolidModel quadratic_body(const mesh::QuadraticTriangleMesh& m, const SolidSpec& spec) {
  return finished(flat_body(Shape::quadratic_triangle, m.nodes, m.triangles), m, spec);
}

SolidModel triangle_body(const mesh::Points2& vertices, const mesh::Triangles& triangles,
                         const SolidSpec& spec) {
  if (spec.order == 2) return quadratic_body(mesh::quadratic(vertices, triangles), spec);
  refuse_quadrature(spec, "triangle");
  return finished(flat_body(Shape::triangle, vertices, triangles), mesh::elements(vertices, triangles));
}

SolidModel triangle_body(const mesh::SurfaceMesh& flat, const SolidSpec& spec) {
  return triangle_body(flat.vertices.leftCols<2>(), flat.triangles, spec);
}

SolidModel quad_body(const mesh::QuadMesh& m, const SolidSpec& spec) {
  return finished(flat_body(Shape::quad, m.vertices, m.quads), m, spec);
}

SolidModel quadratic_body(const mesh::QuadraticTetMesh& m, const SolidSpec& spec) {
  SolidModel body;
  body.shape = Shape::quadratic_tet;
  body.nodes = m.nodes;
  body.surface = mesh::boundary_surface(m);
  return finished(std::move(body), m, spec);
}

SolidModel tet_body(const mesh::TetMesh& tets, const SolidSpec& spec) {
  if (spec.order == 2) return quadratic_body(mesh::quadratic(tets), spec);
  SolidModel body;
  refuse_quadrature(spec, "tet");
  body.shape = Shape::tet;
  body.nodes = tets.vertices;
  const mesh::ElementArrays arrays = mesh::elements(tets);  // names what is wrong before anything else
  body.surface = mesh::boundary_surface(tets);
  return finished(std::move(body), arrays);
}

SolidModel hex_body(const mesh::HexMesh& m, const SolidSpec& spec) {
  SolidModel body;
  body.shape = Shape::hex;
  body.nodes = m.vertices;
  body.surface = mesh::boundary_surface(m);
  return finished(std::move(body), m, spec);
}

SolidModel make_bar(const BarSpec& bar, SolidSpec spec) {
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
  const SolidSpec& spec;

  SolidModel operator()(const BarSpec& bar) const { return make_bar(bar, spec); }
  SolidModel operator()(const GridSpec& g) const {
    const auto make = g.crossed ? mesh::crossed_grid : mesh::grid;
    return triangle_body(make(g.cells[0], g.cells[1], g.size[0], g.size[1]), spec);
  }
  SolidModel operator()(const DiscSpec& disc) const { return triangle_body(mesh::disc(disc.rings), spec); }
  SolidModel operator()(const BallSpec& ball) const { return tet_body(mesh::ball(ball.cells), spec); }
  SolidModel operator()(const QuadrupedSpec& animal) const {
    return tet_body(mesh::quadruped(animal.cells), spec);
  }
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

SolidModel body_of(const ElementMesh& m, const SolidSpec& spec) {
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

// Coordinates of scenes are along these. Adding zero makes one zero of two.
std::string axes_text(const Plane& plane) {
  const auto along = [](const Eigen::Vector3d& a) {
    return formatted("(%.4g, %.4g, %.4g)", a[0] + 0.0, a[1] + 0.0, a[2] + 0.0);
  };
  return "flat, in a plane of its own: x of the scene runs along " + along(plane.u) +
         " of the file and y along " + along(plane.v);
}

}  // namespace

GeneratedSolid refined(GeneratedSolid body, int factor) {
  std::visit(Multiplier{factor}, body);
  return body;
}

SolidModel load_solid(const SolidSpec& spec) {
  if (spec.generated) {
    SolidModel body = std::visit(Maker{spec}, *spec.generated);
    body.name = generated_names[spec.generated->index()];
    return body;
  }
  return solid_from(read_solid_file(spec), spec);
}

SolidModel solid_from(ElementMesh m, const SolidSpec& spec) {
  return with_error_prefix(spec.file.string(), [&] {
    std::optional<Plane> plane;
    if (mesh::shape_dim(m.shape) == 2) plane = flatten(m);
    if (plane && plane->v != Plane().v) log(LogLevel::info, spec.file.string() + ": " + axes_text(*plane));
    mend(m, spec.repair, spec.file.string());
    SolidModel body = body_of(m, spec);
    body.name = spec.file.filename().string();
    body.plane = plane;
    body.groups = std::move(m.groups);
    return body;
  });
}

Vector SolidModel::rest_positions() const {
  Vector x(nodes.rows() * dim);
  for (Eigen::Index n = 0; n < nodes.rows(); ++n)
    for (int i = 0; i < dim; ++i) x[dim * n + i] = nodes(n, i);
  return x;
}

mesh::Points3 SolidModel::points(const Vector& positions) const {
  mesh::Points3 result = mesh::Points3::Zero(nodes.rows(), 3);
  for (Eigen::Index n = 0; n < nodes.rows(); ++n)
    for (int i = 0; i < dim; ++i) result(n, i) = positions[dim * n + i];
  return result;
}

mesh::Points3 SolidModel::placed(const mesh::Points3& points) const {
  if (!plane) return points;
  mesh::Points3 result(points.rows(), 3);
  for (Eigen::Index n = 0; n < points.rows(); ++n)
    result.row(n) = (plane->origin + points(n, 0) * plane->u + points(n, 1) * plane->v).transpose();
  return result;
}

handles::Nodes SolidModel::selectable() const {
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

std::vector<bool> SolidModel::in_elements() const {
  std::vector<bool> used(static_cast<std::size_t>(nodes.rows()), false);
  for (const int node : elements.nodes) used[static_cast<std::size_t>(node)] = true;
  return used;
}

double SolidModel::diagonal() const {
  return box_of(nodes, in_elements()).diagonal().norm();
}

double SolidModel::volume() const {
  return std::accumulate(elements.weights.begin(), elements.weights.end(), 0.0);
}

std::vector<double> SolidModel::volumes() const {
  const auto points = static_cast<std::size_t>(elements.points_per_element);
  std::vector<double> result(static_cast<std::size_t>(elements.element_count()), 0.0);
  for (std::size_t i = 0; i < elements.weights.size(); ++i) result[i / points] += elements.weights[i];
  return result;
}

std::string SolidModel::element_text(int element) const {
  const auto k = static_cast<std::size_t>(elements.nodes_per_element);
  std::string text = std::string(mesh::shape_name(shape)) + " " + std::to_string(element) + " (vertices";
  for (std::size_t c = 0; c < k; ++c)
    text.append(" ").append(std::to_string(elements.nodes[static_cast<std::size_t>(element) * k + c]));
  return text + ")";
}

std::string SolidModel::fingerprint() const {
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

}  // namespace isostretch::deformation
