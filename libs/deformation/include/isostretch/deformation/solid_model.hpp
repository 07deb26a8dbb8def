#pragma once

#include <isostretch/assembly/elements.hpp>
#include <isostretch/core/vector.hpp>
#include <isostretch/handles/selection.hpp>
#include <isostretch/mesh/element_mesh.hpp>
#include <isostretch/mesh/shape.hpp>
#include <isostretch/surface/boundary_surface.hpp>

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace isostretch::deformation {

/// A box of elements from the origin to `size`; two numbers each make a rectangle in the plane.
struct BarSpec {
  std::vector<int> cells;                ///< Cells along each axis.
  std::vector<double> size;              ///< Lengths along each axis.
  mesh::Shape shape = mesh::Shape::tet;  ///< Shape of the elements.
};

/// A rectangle of cells, each cut into two triangles or, crossed, into four around its middle.
struct GridSpec {
  std::array<int, 2> cells{};        ///< Cells along each axis.
  std::array<double, 2> size{1, 1};  ///< Lengths along each axis.
  bool crossed = true;               ///< Whether each cell is cut into four triangles.
};

/// The unit disk, as mesh::disc() makes it.
struct DiscSpec {
  int rings = 0;  ///< Rings of triangles.
};
/// The unit ball, as mesh::ball() makes it.
struct BallSpec {
  int cells = 0;  ///< Cells along each axis, even.
};
/// An animal on four legs, as mesh::quadruped() makes it.
struct QuadrupedSpec {
  int cells = 0;  ///< Cells along its length, at least 12.
};

/// A body that is generated, not read from a file.
using GeneratedSolid = std::variant<BarSpec, GridSpec, DiscSpec, BallSpec, QuadrupedSpec>;

/// Returns the body with `factor` times the cells in every direction. Throws Error where they are too many to
/// count.
GeneratedSolid refined(GeneratedSolid body, int factor);

/// The repairs of the mesh of a file, before anything else is done with it.
struct MeshRepair {
  bool repair = false;         ///< Removes elements that are there twice, and turns inverted ones.
  bool offered = true;         ///< Whether an option of the app repairs, so that messages may name it.
  std::optional<double> weld;  ///< Makes one vertex of those no farther apart.
};

/// The place of a flat body in space: the unit vectors of its axes, and its origin.
struct Plane {
  Eigen::Vector3d u = Eigen::Vector3d::UnitX();      ///< Unit vector of the first axis.
  Eigen::Vector3d v = Eigen::Vector3d::UnitY();      ///< Unit vector of the second axis.
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();  ///< Place of (0, 0).

  /// Returns whether both planes have the same numbers.
  bool operator==(const Plane& other) const { return u == other.u && v == other.v && origin == other.origin; }
};

/// The choices of load_solid(): a file or a generated body, and how its elements are made.
struct SolidSpec {
  std::filesystem::path file = {};               ///< File to read, unless the body is generated.
  std::optional<GeneratedSolid> generated = {};  ///< Body to generate, unless it is read.
  /// Order of the elements; 2 makes linear tets and triangles quadratic, with straight edges.
  int order = 1;
  int quadrature = 0;      ///< Degree of the quadrature; 0 takes the shape's own.
  MeshRepair repair = {};  ///< Repairs of the file's mesh.
};

/// A body to be deformed: solid elements in space, or flat ones in the plane (dim 2).
struct SolidModel {
  std::string name;                        ///< Name of the file, or the kind of generated body.
  mesh::Shape shape = mesh::Shape::tet;    ///< Shape of the elements.
  int dim = 3;                             ///< Dimension, 2 or 3.
  mesh::Points3 nodes;                     ///< N x 3, rest positions; z = 0 in 2D.
  std::optional<Plane> plane;              ///< Where the file has a body of 2D, unless that is z = 0.
  std::vector<mesh::ElementGroup> groups;  ///< Groups of the file.
  assembly::Elements elements;             ///< Elements at rest.
  /// Elements with the shape's own quadrature, where that has more points.
  std::optional<assembly::Elements> richer;
  mesh::BoundarySurface surface;  ///< Surface that is seen: the outside, or everything in 2D.
  /// Edges of the surface, or of the outline in 2D, as pairs of nodes.
  std::vector<std::array<int, 2>> boundary_edges;

  /// Returns elements with points enough that no deformation but a rigid one goes unseen.
  const assembly::Elements& full_rank_elements() const { return richer ? *richer : elements; }
  Vector rest_positions() const;  ///< Returns the rest positions, dim entries per node.
  /// Returns positions as rows of three, z = 0 in 2D.
  mesh::Points3 points(const Vector& positions) const;
  /// Returns rows of points moved to where the file has the body: a flat one in its plane.
  mesh::Points3 placed(const mesh::Points3& points) const;
  std::vector<bool> in_elements() const;  ///< Returns for every node whether it belongs to an element.
  /// Returns the nodes from which handles are selected.
  handles::Nodes selectable() const;
  double diagonal() const;              ///< Returns the diagonal of the box around the elements at rest.
  double volume() const;                ///< Returns the volume, or area, at rest.
  std::vector<double> volumes() const;  ///< Returns the volume, or area, of every element at rest.
  /// Returns an element with its vertices: "tet 17 (vertices 3 9 12 40)".
  std::string element_text(int element) const;
  /// Returns a hash that changes with every bit of the rest shape: 16 hexadecimal digits.
  std::string fingerprint() const;
};

/// Reads or generates a body. Throws Error naming the file and the element for elements that are inverted,
/// degenerate or otherwise unusable; tells in a notice what was repaired, and when every solid element of a
/// file is numbered the other way round and was turned. Flat elements of a file may lie in any plane; one in
/// the plane z = c keeps its x and y, in others u is the first axis that is not across, turned into the
/// plane, and areas are positive.
SolidModel load_solid(const SolidSpec& spec);

/// Makes the body of the elements of spec.file, once they are read, as load_solid() does.
SolidModel solid_from(mesh::ElementMesh m, const SolidSpec& spec);

/// Returns the plural of a shape's name: "tets", "hexes".
std::string plural_name(mesh::Shape shape);

/// Returns the names of shapes in scenes: triangle, quadratic_triangle, quad, tet, quadratic_tet, hex.
std::vector<std::string> shape_names();
/// Returns the shape of a name in scenes, which must be one of shape_names().
mesh::Shape shape_from_name(const std::string& name);

}  // namespace isostretch::deformation
