// Elements of bodies: kinds, orders of nodes, copies, groups.
#include "contents.hpp"
#include "meshes.hpp"

#include <isostretch/core/error.hpp>
#include <isostretch/mesh_io/io.hpp>

#include <doctest/doctest.h>

#include <array>
#include <bit>
#include <cstdint>
#include <string>
#include <vector>

using namespace isostretch;
using namespace isostretch::mesh;
using namespace isostretch::mesh::test;

namespace {

const std::string msh2 = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n";
const std::string five_nodes = "$Nodes\n5\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n5 1 1 1\n$EndNodes\n";

std::string elements2(const std::vector<std::string>& lines) {
  std::string text = "$Elements\n";
  text.append(std::to_string(lines.size())).append("\n");
  for (const std::string& line : lines) text += line + "\n";
  return text + "$EndElements\n";
}

using Indices = std::vector<int>;

Indices flat(const ElementMesh& mesh) {
  return {mesh.elements.data(), mesh.elements.data() + mesh.elements.size()};
}

const std::string vtk_grid = "# vtk DataFile Version 3.0\nt\nASCII\nDATASET UNSTRUCTURED_GRID\n";
const std::string cube = "POINTS 9 double\n0 0 0 1 0 0 1 1 0 0 1 0\n0 0 1 1 0 1 1 1 1 0 1 1\n0.5 0.5 2\n";
const std::string second_order =
    "0 0 0\n1 0 0\n0 1 0\n0 0 1\n.5 0 0\n.5 .5 0\n0 .5 0\n0 0 .5\n.5 0 .5\n0 .5 .5\n";  // VTK's order

}  // namespace

TEST_CASE("MSH 2.2: an element written once for each of its physical groups is one") {
  const std::string text =
      msh2 + "$PhysicalNames\n2\n3 1 \"body\"\n3 2 \"steel\"\n$EndPhysicalNames\n" + five_nodes;
  for (const auto& numbers : {std::array{1, 2, 3, 4}, std::array{1, 1, 2, 2}}) {
    std::vector<std::string> lines;
    for (int i = 0; i < 4; ++i)
      lines.push_back(std::to_string(numbers[static_cast<std::size_t>(i)]) + " 4 2 " +
                      std::to_string(i % 2 + 1) + " 1 " + (i < 2 ? "1 2 3 4" : "2 3 4 5"));
    CHECK(parse_msh_tets(text + elements2(lines), "m.msh").tets == rows<Tets>({0, 1, 2, 3, 1, 2, 3, 4}));
    const ElementMesh mesh = parse_msh_elements(text + elements2(lines), "m.msh");
    CHECK(flat(mesh) == Indices{0, 1, 2, 3, 1, 2, 3, 4});
    REQUIRE(mesh.groups.size() == 2);
    CHECK(mesh.groups[1].name == "steel");
    for (const ElementGroup& group : mesh.groups) CHECK(group.elements == Indices{0, 1});
  }
  const std::string faces =
      elements2({"1 2 2 1 1 1 2 3", "2 2 2 2 1 1 2 3", "3 3 2 1 1 1 2 5 3", "3 3 2 2 1 1 2 5 3"});
  CHECK(parse_msh_surface(text + faces, "m.msh").triangles.rows() == 3);
}

TEST_CASE("MSH 2.2 binary: copies for groups are one, in either byte order") {
  for (const std::endian order : {std::endian::little, std::endian::big}) {
    Contents file(order);
    file.text("$MeshFormat\n2.2 1 8\n").bytes(1).text("\n$EndMeshFormat\n$Nodes\n4\n");
    for (int n = 0; n < 4; ++n)
      file.bytes(n + 1).bytes(n == 1 ? 1. : 0.).bytes(n == 2 ? 1. : 0.).bytes(n == 3 ? 1. : 0.);
    file.text("\n$EndNodes\n$Elements\n2\n").bytes(4).bytes(2).bytes(2);
    for (const int group : {1, 2})
      for (const int number : {group, group, 1, 1, 2, 3, 4}) file.bytes(number);
    file.text("\n$EndElements\n");
    CHECK(parse_msh_tets(file.str(), "m.msh").tets == rows<Tets>({0, 1, 2, 3}));
    CHECK(parse_msh_elements(file.str(), "m.msh").groups.size() == 2);
  }
}

TEST_CASE("MSH: what is no copy stays, and one number for two elements is refused") {
  // The same nodes without groups, in one group twice, or of another entity are no copies for groups.
  for (const char* second :
       {"2 4 0 1 2 3 4", "2 4 2 1 1 1 2 3 4", "2 4 2 2 7 1 2 3 4", "2 4 2 2 1 1 3 2 4"}) {
    CAPTURE(second);
    CHECK(parse_msh_tets(msh2 + five_nodes + elements2({"1 4 2 1 1 1 2 3 4", second}), "m.msh").tets.rows() ==
          2);
  }
  CHECK_THROWS_WITH_AS(
      parse_msh_tets(msh2 + five_nodes + elements2({"7 4 2 1 1 1 2 3 4", "7 4 2 1 1 2 3 4 5"}), "m.msh"),
      doctest::Contains("element 7 for the second time, with other vertices"), Error);
  CHECK_THROWS_WITH_AS(
      parse_msh_surface(msh2 + five_nodes + elements2({"7 2 2 1 1 1 2 3", "7 2 2 1 1 2 3 4"}), "m.msh"),
      doctest::Contains("element 7 for the second time, with other vertices"), Error);
}

TEST_CASE("MSH 4: groups come from the entities, in text and binary") {
  for (const char* version : {"4", "4.1"}) {
    const bool point = version == std::string("4.1");
    std::string text =
        std::string("$MeshFormat\n") + version + " 0 8\n$EndMeshFormat\n" +
        "$PhysicalNames\n2\n2 5 \"skin\"\n3 5 \"bone marrow\"\n$EndPhysicalNames\n$Entities\n1 0 0 2\n" +
        (point ? "1 0 0 0 0\n" : "1 0 0 0 0 0 0 0\n") +
        "1 0 0 0 1 1 1 2 5 6 0\n2 0 0 0 1 1 1 1 -6 0\n$EndEntities\n";
    text += point ? "$Nodes\n1 5 1 5\n3 1 0 5\n1\n2\n3\n4\n5\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n1 1 1\n$EndNodes\n"
                    "$Elements\n2 2 1 2\n3 1 4 1\n1 1 2 3 4\n3 2 4 1\n2 2 3 4 5\n$EndElements\n"
                  : "$Nodes\n1 5\n1 3 0 5\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n5 1 1 1\n$EndNodes\n"
                    "$Elements\n2 2\n1 3 4 1\n1 1 2 3 4\n2 3 4 1\n2 2 3 4 5\n$EndElements\n";
    const ElementMesh mesh = parse_msh_elements(text, "m.msh");
    REQUIRE(mesh.groups.size() == 2);
    CHECK(mesh.groups[0].number == 5);
    CHECK(mesh.groups[0].name == "bone marrow");
    CHECK(mesh.groups[0].elements == Indices{0});
    CHECK(mesh.groups[1].name.empty());
    CHECK(mesh.groups[1].elements == Indices{0, 1});
  }
}

TEST_CASE("MSH 4: groups of a mesh that is partitioned come from the parts, in text and binary") {
  const auto check = [](const ElementMesh& mesh) {
    REQUIRE(mesh.groups.size() == 2);
    CHECK(mesh.groups[0].name == "left");
    CHECK(mesh.groups[0].elements == Indices{0, 1});
    CHECK(mesh.groups[1].name == "right");
    CHECK(mesh.groups[1].elements == Indices{1});
  };
  // Volume 1 is cut into parts 2 and 3; the latter lies on two partitions, and is in two groups.
  const std::string names = "$PhysicalNames\n2\n3 5 \"left\"\n3 6 \"right\"\n$EndPhysicalNames\n";
  for (const bool newer : {false, true}) {
    std::string text = "$MeshFormat\n" + std::string(newer ? "4.1" : "4") + " 0 8\n$EndMeshFormat\n" + names +
                       "$Entities\n0 0 0 1\n1 0 0 0 1 1 1 1 5 0\n$EndEntities\n$PartitionedEntities\n2\n1\n"
                       "9 2\n1 0 0 2\n" +
                       (newer ? "4 0 1 1 1 0 0 0 0\n" : "4 0 1 1 1 0 0 0 0 0 0 0\n") +
                       "2 3 1 1 1 0 0 0 1 1 1 1 5 2 7 -8\n3 3 1 2 1 2 0 0 0 1 1 1 2 5 6 0\n"
                       "$EndPartitionedEntities\n";
    text += newer ? "$Nodes\n1 5 1 5\n3 2 0 5\n1\n2\n3\n4\n5\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n1 1 1\n$EndNodes\n"
                    "$Elements\n2 2 1 2\n3 2 4 1\n1 1 2 3 4\n3 3 4 1\n2 2 3 4 5\n$EndElements\n"
                  : "$Nodes\n1 5\n2 3 0 5\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n5 1 1 1\n$EndNodes\n"
                    "$Elements\n2 2\n2 3 4 1\n1 1 2 3 4\n3 3 4 1\n2 2 3 4 5\n$EndElements\n";
    check(parse_msh_elements(text, "m.msh"));
  }
  Contents file(std::endian::little);
  file.text("$MeshFormat\n4.1 1 8\n").bytes(1).text("\n$EndMeshFormat\n" + names + "$PartitionedEntities\n");
  for (const std::int64_t number : {2, 1}) file.bytes(number);
  file.bytes(9).bytes(2);
  for (const std::int64_t number : {0, 0, 0, 2}) file.bytes(number);
  const auto part = [&](int tag, const std::vector<int>& partitions, const std::vector<int>& groups) {
    file.bytes(tag).bytes(3).bytes(1).bytes(std::int64_t{static_cast<int>(partitions.size())});
    for (const int p : partitions) file.bytes(p);
    for (int i = 0; i < 6; ++i) file.bytes(0.5);
    file.bytes(std::int64_t{static_cast<int>(groups.size())});
    for (const int g : groups) file.bytes(g);
    file.bytes(std::int64_t{1}).bytes(7);
  };
  part(2, {1}, {5});
  part(3, {1, 2}, {5, 6});
  file.text("\n$EndPartitionedEntities\n$Nodes\n");
  for (const std::int64_t number : {1, 5, 1, 5}) file.bytes(number);
  file.bytes(3).bytes(2).bytes(0).bytes(std::int64_t{5});
  for (const std::int64_t tag : {1, 2, 3, 4, 5}) file.bytes(tag);
  for (const double x : {0., 0., 0., 1., 0., 0., 0., 1., 0., 0., 0., 1., 1., 1., 1.}) file.bytes(x);
  file.text("\n$EndNodes\n$Elements\n");
  for (const std::int64_t number : {2, 2, 1, 2}) file.bytes(number);
  file.bytes(3).bytes(2).bytes(4).bytes(std::int64_t{1});
  for (const std::int64_t number : {1, 1, 2, 3, 4}) file.bytes(number);
  file.bytes(3).bytes(3).bytes(4).bytes(std::int64_t{1});
  for (const std::int64_t number : {2, 2, 3, 4, 5}) file.bytes(number);
  file.text("\n$EndElements\n");
  check(parse_msh_elements(file.str(), "m.msh"));
}

TEST_CASE("groups of faces, lines and points have their vertices") {
  const std::string names = "$PhysicalNames\n3\n0 9 \"tip\"\n2 1 \"left\"\n3 1 \"bone\"\n$EndPhysicalNames\n";
  const std::string text = msh2 + names + five_nodes +
                           elements2({"1 15 2 9 1 5", "2 1 2 4 1 5 1", "3 2 2 1 1 3 2 1", "4 2 2 1 1 3 2 5",
                                      "5 4 2 1 1 1 2 3 4", "6 15 2 0 1 2"});
  const ElementMesh mesh = parse_msh_elements(text, "m.msh");
  REQUIRE(mesh.groups.size() == 4);
  CHECK(mesh.groups[0].name == "bone");
  CHECK(mesh.groups[0].elements == Indices{0});
  CHECK(mesh.groups[1].name == "left");
  CHECK(mesh.groups[1].vertices == Indices{0, 1, 2, 4});
  CHECK(mesh.groups[2].number == 4);
  CHECK(mesh.groups[2].vertices == Indices{0, 4});
  CHECK(mesh.groups[3].name == "tip");
  CHECK(mesh.groups[3].vertices == Indices{4});
  // Faces that are the body are its elements.
  const ElementMesh flat_body = parse_msh_elements(
      msh2 + names + five_nodes + elements2({"2 1 2 4 1 5 1", "3 2 2 1 1 3 2 1"}), "m.msh");
  REQUIRE(flat_body.groups.size() == 2);
  CHECK(flat_body.groups[0].elements == Indices{0});
  CHECK(flat_body.groups[1].vertices == Indices{0, 4});
}

TEST_CASE("MEDIT: references are groups") {
  const std::string text =
      "MeshVersionFormatted 2\nDimension 3\nVertices\n5\n0 0 0 0\n1 0 0 0\n0 1 0 0\n0 0 1 0\n1 1 1 0\n"
      "Tetrahedra\n3\n1 2 3 4 7\n2 5 3 4 0\n1 2 3 4 1.5\nEnd\n";
  const ElementMesh mesh = parse_medit_elements(text, "m.mesh");
  REQUIRE(mesh.groups.size() == 1);
  CHECK(mesh.groups[0].number == 7);
  CHECK(mesh.groups[0].elements == Indices{0});
}

TEST_CASE("bodies of hexahedra alone, of every format") {
  const Indices corners{0, 1, 2, 3, 4, 5, 6, 7};
  const std::string cell = "CELLS 1 9\n8 0 1 2 3 4 5 6 7\nCELL_TYPES 1\n12\n";
  ElementMesh mesh = parse_vtk_elements(vtk_grid + cube + cell, "m.vtk");
  CHECK(mesh.shape == Shape::hex);
  CHECK(flat(mesh) == corners);
  CHECK(mesh.vertices.rows() == 9);
  const std::string voxel = "CELLS 1 9\n8 0 1 3 2 4 5 7 6\nCELL_TYPES 1\n11\n";
  CHECK(flat(parse_vtk_elements(vtk_grid + cube + voxel, "m.vtk")) == corners);
  const std::string nodes =
      "$Nodes\n8\n1 0 0 0\n2 1 0 0\n3 1 1 0\n4 0 1 0\n5 0 0 1\n6 1 0 1\n7 1 1 1\n8 0 1 1\n$EndNodes\n";
  mesh = parse_msh_elements(msh2 + nodes + elements2({"1 5 2 1 1 1 2 3 4 5 6 7 8", "2 3 2 1 1 1 2 3 4"}),
                            "m.msh");
  CHECK(mesh.shape == Shape::hex);
  CHECK(flat(mesh) == corners);
  mesh = parse_medit_elements(
      "MeshVersionFormatted 2\nDimension 3\nVertices\n8\n0 0 0 0\n1 0 0 0\n1 1 0 0\n0 1 0 0\n0 0 1 0\n1 0 1 "
      "0\n"
      "1 1 1 0\n0 1 1 0\nHexahedra\n1\n1 2 3 4 5 6 7 8 0\nQuadrilaterals\n1\n1 2 3 4 0\nEnd\n",
      "m.mesh");
  CHECK(flat(mesh) == corners);
}

TEST_CASE("no solid element is dropped without a word") {
  const std::string mixed =
      vtk_grid + cube + "CELLS 3 19\n8 0 1 2 3 4 5 6 7\n4 4 5 6 8\n4 4 6 7 8\nCELL_TYPES 3\n12\n10\n10\n";
  for (const bool tets : {false, true}) {
    const auto parse = [&](const std::string& text) {
      tets ? void(parse_vtk_tets(text, "m.vtk")) : void(parse_vtk_elements(text, "m.vtk"));
    };
    CHECK_THROWS_WITH_AS(parse(mixed),
                         doctest::Contains("m.vtk:16: 2 tetrahedra and 1 hexahedron: a body is of one kind"),
                         Error);
    const std::string prism =
        vtk_grid + cube + "CELLS 2 12\n6 0 1 2 4 5 6\n4 4 5 6 8\nCELL_TYPES 2\n13\n10\n";
    CHECK_THROWS_WITH_AS(parse(prism), doctest::Contains("1 tetrahedron and 1 prism: a body is of one kind"),
                         Error);
  }
  CHECK_THROWS_WITH_AS(
      parse_vtk_elements(vtk_grid + cube + "CELLS 1 6\n5 0 1 2 3 8\nCELL_TYPES 1\n14\n", "m.vtk"),
      doctest::Contains("only 1 pyramid"), Error);
  CHECK_THROWS_WITH_AS(
      parse_vtk_elements(vtk_grid + cube + "CELLS 2 9\n3 0 1 2\n4 0 1 2 3\nCELL_TYPES 2\n5\n9\n", "m.vtk"),
      doctest::Contains("1 triangle and 1 quadrangle: a body is of one kind"), Error);
  const std::string nodes = "$Nodes\n6\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n5 1 0 1\n6 0 1 1\n$EndNodes\n";
  CHECK_THROWS_WITH_AS(
      parse_msh_tets(msh2 + nodes + elements2({"1 6 0 1 2 3 4 5 6", "2 4 0 1 2 3 4"}), "m.msh"),
      doctest::Contains("1 tetrahedron and 1 prism"), Error);
  CHECK_THROWS_WITH_AS(parse_msh_tets(msh2 + nodes + elements2({"1 999 0 1 2 3 4 5 6"}), "m.msh"),
                       doctest::Contains("m.msh:15: elements of unknown type 999"), Error);
}

TEST_CASE("elements of second order, their nodes in VTK's order whatever the file's is") {
  const Indices ordered{0, 1, 2, 3, 4, 5, 6, 7, 8, 9}, as_gmsh{0, 1, 2, 3, 4, 5, 6, 7, 9, 8};
  const auto list = [](const Indices& indices, int first) {
    std::string text;
    for (const int i : indices) text.append(" ").append(std::to_string(i + first));
    return text;
  };
  std::string nodes = "$Nodes\n10\n";
  std::string medit = "MeshVersionFormatted 2\nDimension 3\nVertices\n10\n";
  std::string rest = second_order;
  for (int n = 1; n <= 10; ++n) {
    const std::string point = rest.substr(0, rest.find('\n'));
    rest = rest.substr(rest.find('\n') + 1);
    nodes += std::to_string(n) + " " + point + "\n";
    medit += point + " 0\n";
  }
  ElementMesh mesh = parse_msh_elements(
      msh2 + nodes + "$EndNodes\n" + elements2({"1 11 2 1 1" + list(as_gmsh, 1)}), "m.msh");
  CHECK(mesh.shape == Shape::quadratic_tet);
  CHECK(flat(mesh) == ordered);
  for (const Indices& order : {ordered, as_gmsh}) {
    mesh = parse_medit_elements(medit + "TetrahedraP2\n1\n" + list(order, 1) + " 3\nEnd\n", "m.mesh");
    CHECK(flat(mesh) == ordered);
    CHECK(mesh.groups.size() == 1);
  }
  mesh = parse_vtk_elements(vtk_grid + "POINTS 10 double\n" + second_order + "CELLS 1 11\n10" +
                                list(ordered, 0) + "\nCELL_TYPES 1\n24\n",
                            "m.vtk");
  CHECK(mesh.shape == Shape::quadratic_tet);
  CHECK(flat(mesh) == ordered);
  // In the plane: corners 0, 1, 2 and the nodes of their edges.
  const std::string six = "CELLS 1 7\n6 0 1 2 4 5 6\nCELL_TYPES 1\n22\n";
  mesh = parse_vtk_elements(vtk_grid + "POINTS 10 double\n" + second_order + six, "m.vtk");
  CHECK(mesh.shape == Shape::quadratic_triangle);
  CHECK(flat(mesh) == Indices{0, 1, 2, 4, 5, 6});
  mesh = parse_msh_elements(msh2 + nodes + "$EndNodes\n" + elements2({"1 9 0 1 2 3 5 6 7"}), "m.msh");
  CHECK(flat(mesh) == Indices{0, 1, 2, 4, 5, 6});
  mesh = parse_medit_elements(medit + "TrianglesP2\n1\n1 2 3 5 6 7 0\nEnd\n", "m.mesh");
  CHECK(flat(mesh) == Indices{0, 1, 2, 4, 5, 6});
  CHECK_THROWS_WITH_AS(
      parse_msh_tets(msh2 + nodes + "$EndNodes\n" + elements2({"1 11 0" + list(as_gmsh, 1)}), "m.msh"),
      doctest::Contains("no tetrahedra of 4 nodes, only 1 tetrahedron of 10 nodes"), Error);
  CHECK_THROWS_WITH_AS(parse_vtk_surface(vtk_grid + "POINTS 10 double\n" + second_order + six, "m.vtk"),
                       doctest::Contains("no triangles, only 1 triangle of 6 nodes"), Error);
}

TEST_CASE("points, lines and the faces of a solid are no part of a body") {
  const std::string text =
      msh2 + five_nodes +
      elements2({"1 15 2 1 1 1", "2 1 2 1 1 1 2", "3 2 2 1 1 1 2 3", "4 4 2 1 1 1 2 3 4"});
  CHECK(flat(parse_msh_elements(text, "m.msh")) == Indices{0, 1, 2, 3});
  CHECK_THROWS_WITH_AS(parse_msh_elements(msh2 + five_nodes + elements2({"2 1 2 1 1 1 2"}), "m.msh"),
                       doctest::Contains("neither solid ones nor faces"), Error);
}
