#include <isostretch/assembly/elements.hpp>
#include <isostretch/core/error.hpp>
#include <isostretch/core/text.hpp>
#include <isostretch/deformation/solid_check.hpp>
#include <isostretch/deformation/solid_model_file.hpp>
#include <isostretch/fem/quadrature.hpp>
#include <isostretch/fem/shape_functions.hpp>
#include <isostretch/surface/check.hpp>
#include <isostretch/surface/repair.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>

namespace isostretch::deformation {
namespace {

using mesh::ElementMesh;
using mesh::Shape;

constexpr std::size_t most_listed = 5;

// ---- measures of elements ----

// At every corner its neighbours, so that the edges to them have a positive determinant.
std::vector<std::vector<int>> corners_of(Shape shape) {
  switch (shape) {
    case Shape::triangle:
    case Shape::quadratic_triangle:
      return {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}};
    case Shape::quad:
      return {{0, 1, 3}, {1, 2, 0}, {2, 3, 1}, {3, 0, 2}};
    case Shape::tet:
    case Shape::quadratic_tet:
      return {{0, 1, 2, 3}, {1, 0, 3, 2}, {2, 3, 0, 1}, {3, 2, 1, 0}};
    case Shape::hex:
      break;
  }
  return {{0, 1, 3, 4}, {1, 2, 0, 5}, {2, 3, 1, 6}, {3, 0, 2, 7},
          {4, 7, 5, 0}, {5, 4, 6, 1}, {6, 5, 7, 2}, {7, 6, 4, 3}};
}

// What makes a regular element 1.
double regular_factor(Shape shape) {
  if (shape == Shape::tet || shape == Shape::quadratic_tet) return std::sqrt(2.0);
  return shape == Shape::triangle || shape == Shape::quadratic_triangle ? 2 / std::sqrt(3.0) : 1.0;
}

// The scaled Jacobian (Knupp 2000): the least determinant of the unit vectors along the edges of a corner.
double scaled_jacobian(const ElementMesh& m, int e) {
  double least = 1;
  for (const std::vector<int>& corner : corners_of(m.shape)) {
    Eigen::Matrix3d edges = Eigen::Matrix3d::Identity();
    for (std::size_t i = 1; i < corner.size(); ++i) {
      const Eigen::Vector3d edge =
          m.vertices.row(m.elements(e, corner[i])) - m.vertices.row(m.elements(e, corner[0]));
      edges.col(static_cast<Eigen::Index>(i) - 1) = edge.stableNormalized();
    }
    least = std::min(least, regular_factor(m.shape) * edges.determinant());
  }
  return least;
}

// Of every element, or its area; negative where it is inverted.
std::vector<double> signed_volumes(const ElementMesh& m) {
  const mesh::QuadratureRule rule = mesh::quadrature_rule(m.shape, mesh::default_degree(m.shape));
  const int dim = rule.dim, count = mesh::shape_node_count(m.shape);
  std::vector<double> volumes(static_cast<std::size_t>(m.elements.rows()), 0.0),
      gradients(static_cast<std::size_t>(count * dim));
  for (int q = 0; q < rule.size(); ++q) {
    mesh::shape_gradients(m.shape, rule.points.data() + static_cast<std::ptrdiff_t>(q) * dim,
                          gradients.data());
    for (Eigen::Index e = 0; e < m.elements.rows(); ++e) {
      Eigen::Matrix3d jacobian = Eigen::Matrix3d::Zero();
      // Differences from the first node: what is far from the origin loses no digits.
      for (int n = 1; n < count; ++n)
        for (int d = 0; d < dim; ++d)
          jacobian.col(d) +=
              gradients[static_cast<std::size_t>(n * dim + d)] *
              (m.vertices.row(m.elements(e, n)) - m.vertices.row(m.elements(e, 0))).transpose();
      if (dim == 2) jacobian(2, 2) = 1;
      volumes[static_cast<std::size_t>(e)] +=
          rule.weights[static_cast<std::size_t>(q)] * jacobian.determinant();
    }
  }
  return volumes;
}

// ---- text ----

std::string point_text(const Eigen::Vector3d& p) {
  return formatted("(%.6g, %.6g, %.6g)", p[0], p[1], p[2]);
}

std::string more(std::size_t count) {
  return count > most_listed
             ? ", and " + with_thousands(static_cast<long long>(count - most_listed)) + " more"
             : "";
}

std::string box_line(const ElementMesh& m, const std::vector<bool>& used) {
  const Eigen::AlignedBox3d box = box_of(m.vertices, used);
  return "  box: " + point_text(box.min()) + " to " + point_text(box.max()) +
         formatted(", diagonal %.6g\n", box.diagonal().norm());
}

std::string component_line(const ElementMesh& m) {
  assembly::Elements topology;
  topology.nodes_per_element = static_cast<int>(m.elements.cols());
  topology.node_count = static_cast<int>(m.vertices.rows());
  topology.nodes.assign(m.elements.data(), m.elements.data() + m.elements.size());
  const std::vector<int> of_node = assembly::component_of_nodes(topology);
  std::vector<long long> sizes;
  for (Eigen::Index e = 0; e < m.elements.rows(); ++e) {
    const auto c = static_cast<std::size_t>(of_node[static_cast<std::size_t>(m.elements(e, 0))]);
    sizes.resize(std::max(sizes.size(), c + 1), 0);
    ++sizes[c];
  }
  if (sizes.size() == 1) return "  components: 1\n";
  std::string text = formatted("  components: %zu, of ", sizes.size());
  for (std::size_t i = 0; i < std::min(sizes.size(), most_listed); ++i)
    text += (i > 0 ? ", " : "") + with_thousands(sizes[i]);
  return text + " " + plural_name(m.shape) + more(sizes.size()) + "\n";
}

std::string group_lines(const ElementMesh& m) {
  constexpr std::size_t most_groups = 20;
  std::string text;
  for (std::size_t i = 0; i < std::min(m.groups.size(), most_groups); ++i) {
    const mesh::ElementGroup& group = m.groups[i];
    const std::string number = std::to_string(group.number);
    text += "  group " + (group.name.empty() ? number : "'" + group.name + "' (" + number + ")") + ": ";
    text += group.vertices.empty()
                ? counted(std::ssize(group.elements), m.shape)
                : with_thousands(std::ssize(group.vertices)) + " vertices of faces, lines or points";
    text += "\n";
  }
  if (m.groups.size() > most_groups)
    text += formatted("  and %zu groups more\n", m.groups.size() - most_groups);
  return text;
}

std::string volume_lines(const ElementMesh& m, const std::vector<double>& volumes) {
  const char* const what = mesh::shape_dim(m.shape) == 3 ? "volume" : "area";
  const auto [least, most] = std::minmax_element(volumes.begin(), volumes.end());
  const auto line = [&](const char* name, std::vector<double>::const_iterator at) {
    return formatted("  %s: ", name) + element_text(m, static_cast<int>(at - volumes.begin())) +
           formatted(", %s %.6g\n", what, *at);
  };
  return formatted("  %s: %.6g\n", what, std::accumulate(volumes.begin(), volumes.end(), 0.0)) +
         line("smallest", least) + line("largest", most);
}

std::string shape_line(const ElementMesh& m) {
  int worst = 0;
  double least = 2;
  for (int e = 0; e < m.elements.rows(); ++e)
    if (const double quality = scaled_jacobian(m, e); quality < least) least = quality, worst = e;
  return "  worst shape: " + element_text(m, worst) +
         formatted(", scaled Jacobian %.3g (1: regular, 0: flat)\n", least);
}

// ---- faults ----

std::string fault_lines(const ElementMesh& m, const char* what, const std::vector<int>& elements) {
  if (elements.empty()) return {};
  std::string text = formatted("  %s: ", what) + counted(std::ssize(elements), m.shape) + "\n";
  for (std::size_t i = 0; i < std::min(elements.size(), most_listed); ++i)
    text += "    " + element_text(m, elements[i]) + "\n";
  if (elements.size() > most_listed) text += formatted("    and %zu more\n", elements.size() - most_listed);
  return text;
}

// Of the corners alone where elements are of second order.
mesh::MeshDiagnostics report_of(const ElementMesh& m) {
  if (m.shape == Shape::tet || m.shape == Shape::quadratic_tet)
    return mesh::check(mesh::TetMesh{m.vertices, m.elements.leftCols(4)}, most_listed);
  if (m.shape != Shape::triangle && m.shape != Shape::quadratic_triangle) return {};
  mesh::SurfaceMesh surface;
  surface.vertices = m.vertices;
  surface.triangles = m.elements.leftCols(3);
  return mesh::check(surface, most_listed);
}

// What is said elsewhere, or of files where vertices of no element are usual, is left out.
std::string further_lines(const ElementMesh& m) {
  const mesh::MeshDiagnostics report = report_of(m);
  std::string text;
  for (const mesh::DefectKind kind :
       {mesh::DefectKind::degenerate, mesh::DefectKind::zero_size, mesh::DefectKind::non_manifold_edge,
        mesh::DefectKind::non_manifold_face, mesh::DefectKind::non_manifold_vertex,
        mesh::DefectKind::inconsistent_orientation, mesh::DefectKind::not_orientable,
        mesh::DefectKind::duplicate_vertex}) {
    if (report.count(kind) == 0) continue;
    text += "  " + std::string(mesh::defect_kind_name(kind)) + formatted(": %ld\n", report.count(kind));
    for (const mesh::Defect& defect : report.defects)
      if (defect.kind == kind) text += "    " + defect.text + "\n";
    if (const long rest = report.count(kind) - static_cast<long>(most_listed); rest > 0)
      text += formatted("    and %ld more\n", rest);
  }
  return text;
}

std::string description(ElementMesh m, const std::string& name) {
  const std::vector<bool> used = used_vertices(m);
  const auto unused = std::count(used.begin(), used.end(), false);
  std::string text = name + ": " + counted(m.elements.rows(), m.shape) + ", " +
                     with_thousands(m.vertices.rows()) + " vertices" +
                     (unused > 0 ? " (" + with_thousands(unused) + " of no element)" : "") + "\n" +
                     box_line(m, used) + component_line(m) + group_lines(m);
  try {
    if (mesh::shape_dim(m.shape) == 2) flatten(m);
  } catch (const Error&) {
    return text + further_lines(m);  // the verdict says it; areas have no sign
  }
  const mesh::ElementRepairReport faults = mesh::find_faults(m);
  return text + volume_lines(m, signed_volumes(m)) + shape_line(m) +
         fault_lines(m, "inverted, or numbered the other way round", faults.inverted) +
         fault_lines(m, "there twice", faults.duplicates) + further_lines(m);
}

// With what --repair does, where it was asked for and all can be mended: the verdict is of such a body.
ElementMesh mended(ElementMesh m, const SolidSpec& spec) {
  if (!spec.repair.repair) return m;
  ElementMesh result = m;
  try {
    mend(result, spec.repair, spec.file.string());
    return result;
  } catch (const Error&) {
    return m;  // the verdict says why
  }
}

// A generated body as if it had been read.
ElementMesh elements_of(const SolidModel& body) {
  ElementMesh m;
  m.shape = body.shape;
  m.vertices = body.nodes;
  m.elements.resize(body.elements.element_count(), body.elements.nodes_per_element);
  std::copy(body.elements.nodes.begin(), body.elements.nodes.end(), m.elements.data());
  return m;
}

}  // namespace

SolidCheck check_solid(const SolidSpec& spec, const std::function<void(const SolidModel&)>& require) {
  SolidCheck check;
  const auto load = [&](const auto& make) {
    try {
      SolidModel body = make();
      if (require) require(body);
      check.body = std::move(body);
    } catch (const Error& error) {
      check.trouble = error.what();
    }
  };
  if (spec.generated) {
    const SolidModel body = load_solid(spec);
    check.text = description(elements_of(body), body.name);
    load([&] { return body; });
  } else {
    const ElementMesh m = mended(read_solid_file(spec), spec);
    check.text = description(m, spec.file.string());
    load([&] { return solid_from(m, spec); });
  }
  return check;
}

}  // namespace isostretch::deformation
