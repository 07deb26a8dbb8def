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
  std::vector<int> cells;
  std::vector<double> size;
  mesh::Shape shape = mesh::Shape::tet;
};

/// A rectangle of cells, each cut into two triangles or, crossed, into four around its middle.
struct GridSpec {
  std::array<int, 2> cells{};
  std::array<double, 2> size{1, 1};
  bool crossed = true;
};

/// The unit disc, the unit ball, and an animal on four legs: see mesh/generators.hpp.
struct DiscSpec {
  int rings = 0;
};
struct BallSpec {
  int cells = 0;
};
struct QuadrupedSpec {
  int cells = 0;
};

using GeneratedSolid = std::variant<BarSpec, GridSpec, DiscSpec, BallSpec, QuadrupedSpec>;

/// The same with so many times the cells in every direction. Throws Error where they are too many to count.
GeneratedSolid refined(GeneratedSolid body, int factor);

/// What is done to the mesh of a file before anything else.
struct MeshRepair {
  bool repair = false;         ///< elements that are there twice go, inverted ones are turned
  bool offered = true;         ///< an option of the app does that, and messages may name it
  std::optional<double> weld;  ///< vertices no farther apart become one
};

/// Where a flat body lies in space: the unit vectors of its axes, and its origin.
struct Plane {
  Eigen::Vector3d u = Eigen::Vector3d::UnitX(), v = Eigen::Vector3d::UnitY(),
                  origin = Eigen::Vector3d::Zero();

  bool operator==(const Plane& other) const { return u == other.u && v == other.v && origin == other.origin; }
};

struct SolidSpec {
  std::filesystem::path file = {};  ///< unless it is generated
  std::optional<GeneratedSolid> generated = {};
  int order = 1;       ///< 2: linear tets and triangles become quadratic, with straight edges
  int quadrature = 0;  ///< degree; 0: the shape's own
  MeshRepair repair = {};
};

/// What is deformed: solid elements in space, or flat ones in the plane (dim 2).
struct SolidModel {
  std::string name;  ///< of the file, or the kind of generated body
  mesh::Shape shape = mesh::Shape::tet;
  int dim = 3;
  mesh::Points3 nodes;                       ///< at rest; z = 0 in 2D
  std::optional<Plane> plane;                ///< 2D: where the file has it, unless that is z = 0
  std::vector<mesh::ElementGroup> groups;    ///< of the file
  assembly::Elements elements;               ///< at rest
  std::optional<assembly::Elements> richer;  ///< with the shape's own quadrature, where that has more points
  mesh::BoundarySurface surface;             ///< what is seen of it: outside, or everything in 2D
  std::vector<std::array<int, 2>> boundary_edges;  ///< of the surface, or of the outline in 2D; nodes

  /// Points enough that no deformation but a rigid one goes unseen.
  const assembly::Elements& full_rank_elements() const { return richer ? *richer : elements; }
  Vector rest_positions() const;  ///< dim entries a node
  /// Rows of three, z = 0 in 2D.
  mesh::Points3 points(const Vector& positions) const;
  /// Such rows where the file has the body: a flat one in its plane.
  mesh::Points3 placed(const mesh::Points3& points) const;
  std::vector<bool> in_elements() const;  ///< of every node
  handles::Nodes selectable() const;
  double diagonal() const;              ///< of the box around its elements at rest
  double volume() const;                ///< or area, at rest
  std::vector<double> volumes() const;  ///< of every element
  /// "tet 17 (vertices 3 9 12 40)".
  std::string element_text(int element) const;
  /// Changes with every bit of the rest shape: 16 hexadecimal digits.
  std::string fingerprint() const;
};

/// Reads or makes it. Throws Error naming the file and the element for elements that are inverted, degenerate
/// or otherwise unusable; tells in a notice what was repaired, and when every solid element of a file is
/// numbered the other way round and was turned. Flat elements of a file may lie in any plane; one in the
/// plane z = c keeps its x and y, in others u is the first axis that is not across, turned into the plane,
/// and areas are positive.
SolidModel load_solid(const SolidSpec& spec);

/// Makes the body of the elements of spec.file, once they are read, as load_solid() does.
SolidModel solid_from(mesh::ElementMesh m, const SolidSpec& spec);

/// "tets", "hexes".
std::string plural_name(mesh::Shape shape);

/// By the names elements have in scenes: triangle, quadratic_triangle, quad, tet, quadratic_tet, hex.
std::vector<std::string> shape_names();
mesh::Shape shape_from_name(const std::string& name);

}  // namespace isostretch::deformation
