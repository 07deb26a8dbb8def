#include <isostretch/core/error.hpp>
#include <isostretch/core/log.hpp>
#include <isostretch/core/text.hpp>
#include <isostretch/deformation/solid_model_file.hpp>
#include <isostretch/mesh/weld.hpp>
#include <isostretch/mesh_io/io.hpp>
#include <isostretch/surface/repair.hpp>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace isostretch::deformation {

using mesh::ElementMesh;
using mesh::Shape;

namespace {

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

std::string listed_elements(const std::vector<int>& elements) {
  constexpr std::size_t most = 10;
  std::string text;
  for (std::size_t i = 0; i < std::min(most, elements.size()); ++i)
    text += (i > 0 ? ", " : "") + std::to_string(elements[i]);
  return text + (elements.size() > most ? ", ..." : "");
}

}  // namespace

std::string counted(std::ptrdiff_t count, Shape shape) {
  return with_thousands(count) + " " + (count == 1 ? mesh::shape_name(shape) : plural_name(shape));
}

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

std::string element_text(const ElementMesh& m, int e) {
  std::string text = std::string(mesh::shape_name(m.shape)) + " " + std::to_string(e) + " (vertices";
  for (Eigen::Index c = 0; c < m.elements.cols(); ++c)
    text.append(" ").append(std::to_string(m.elements(e, c)));
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
    log(LogLevel::info,
        file + ": every " + mesh::shape_name(m.shape) + " is numbered the other way round; all were turned");
  else if (!faults.inverted.empty())
    log(LogLevel::info, file + ": repair: " + counted(std::ssize(faults.inverted), m.shape) +
                            " turned: " + listed_elements(faults.inverted));
  if (!faults.duplicates.empty())
    log(LogLevel::info, file + ": repair: " + counted(std::ssize(faults.duplicates), m.shape) +
                            " there twice, left out: " + listed_elements(faults.duplicates));
}

ElementMesh read_solid_file(const SolidSpec& spec) {
  const std::string path = spec.file.string();
  ElementMesh m =
      mesh::read_elements(path, {.leave_out_faces = spec.repair.repair,
                                 .face_advice = spec.repair.offered ? "; --repair leaves it out" : ""});
  if (spec.repair.weld)
    if (const int welded =
            with_error_prefix(spec.file.string(), [&] { return mesh::weld(m, *spec.repair.weld); });
        welded > 0)
      log(LogLevel::info, path + ": " + std::to_string(welded) + " vertices welded to others");
  return m;
}

}  // namespace isostretch::deformation
