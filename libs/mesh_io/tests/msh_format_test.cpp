#include "contents.hpp"
#include "meshes.hpp"

#include <isostretch/core/error.hpp>
#include <isostretch/mesh_io/io.hpp>

#include <doctest/doctest.h>

#include <bit>
#include <cstdint>
#include <string>

using namespace isostretch;
using namespace isostretch::mesh;
using namespace isostretch::mesh::test;

namespace {

const std::string head2 = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n";
const std::string nodes2 = "$Nodes\n4\n1 0 0 0\n2 1 0 0\n3 1 1 0\n4 0 1 0\n$EndNodes\n";
const std::string head4 = "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n";

void refused(const std::string& contents, const char* message) {
  CAPTURE(contents);
  CHECK_THROWS_WITH_AS(parse_msh_surface(contents, "m.msh"), message, Error);
}

}  // namespace

TEST_CASE("MSH 2.2: names, partition tags, elements of other types, data") {
  const SurfaceMesh mesh =
      parse_msh_surface(head2 + "$PhysicalNames\n1\n2 7 \"wing $Nodes\"\n$EndPhysicalNames\n" + nodes2 +
                            "$Elements\n4\n1 15 2 0 1 1\n2 8 2 0 1 1 2 3\n3 2 4 7 1 1 1 1 2 3\n9 2 0 1 "
                            "3 4\n$EndElements\n"
                            "$NodeData\n1\n\"value\"\n$EndNodeData\n",
                        "m.msh");
  CHECK(mesh.triangles == rows<Triangles>({0, 1, 2, 0, 2, 3}));
}

TEST_CASE("MSH: node tags with gaps, out of order, and far apart") {
  for (const char* far : {"7", "123456789012"}) {
    const SurfaceMesh mesh =
        parse_msh_surface(head4 + "$Nodes\n2 4 3 " + far + "\n0 1 0 1\n" + far +
                              "\n0 0 0\n2 1 0 3\n5\n3\n4\n1 0 0\n1 1 0\n0 1 0\n$EndNodes\n"
                              "$Elements\n1 2 1 2\n2 1 2 2\n1 " +
                              far + " 5 3\n2 " + far + " 3 4\n$EndElements\n",
                          "m.msh");
    CHECK(mesh.vertices == rows<Points3>({0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0}));
    CHECK(mesh.triangles == rows<Triangles>({0, 1, 2, 0, 2, 3}));
  }
}

TEST_CASE("MSH: repeated sections are read as one, in time that grows as the file does") {
  std::string text = head2;
  constexpr int nodes = 100000;
  for (int n = 1; n <= nodes; ++n) text += "$Nodes\n1\n" + std::to_string(n) + " 0 0 0\n$EndNodes\n";
  for (int n = 3; n <= nodes; ++n)
    text += "$Elements\n1\n" + std::to_string(n) + " 2 0 1 2 " + std::to_string(n) + "\n$EndElements\n";
  const SurfaceMesh mesh = parse_msh_surface(text, "m.msh");
  CHECK(mesh.vertices.rows() == nodes);
  CHECK(mesh.triangles.row(nodes - 3) == Eigen::RowVector3i(0, 1, nodes - 1));
}

TEST_CASE("MSH 4: parametric nodes and quadrangles") {
  const std::string text =
      head4 +
      "$Entities\n0 0 1 0\n1 0 0 0 1 1 0 0 0\n$EndEntities\n$Nodes\n1 4 1 4\n2 1 1 4\n1\n2\n3\n4\n"
      "0 0 0 0.5 0.5\n1 0 0 0 0\n1 1 0 0 0\n0 1 0 0 0\n$EndNodes\n$Elements\n1 1 1 1\n2 1 3 1\n1 1 2 3 "
      "4\n$EndElements\n";
  CHECK(parse_msh_surface(text, "m.msh").triangles == rows<Triangles>({0, 1, 2, 0, 2, 3}));
}

TEST_CASE("MSH 4.1 binary: entities may hold any words, parameters of nodes are skipped") {
  for (const std::endian order : {std::endian::little, std::endian::big}) {
    Contents file(order);
    file.text("$MeshFormat\n4.1 1 8\n").bytes(1).text("\n$EndMeshFormat\n$Entities\n");
    for (const std::int64_t count : {0, 0, 1, 0}) file.bytes(count);
    file.bytes(7);
    for (int i = 0; i < 6; ++i) file.text("$Nodes\n ");
    file.bytes(std::int64_t{0}).bytes(std::int64_t{0}).text("\n$EndEntities\n$Nodes\n");
    for (const std::int64_t number : {1, 3, 1, 3}) file.bytes(number);
    file.bytes(2).bytes(1).bytes(1).bytes(std::int64_t{3});
    for (const std::int64_t tag : {1, 2, 3}) file.bytes(tag);
    for (const double number : {0., 0., 0., 9., 9., 1., 0., 0., 9., 9., 0., 1., 0., 9., 9.})
      file.bytes(number);
    file.text("\n$EndNodes\n$Elements\n");
    for (const std::int64_t number : {2, 2, 1, 2}) file.bytes(number);
    file.bytes(1).bytes(1).bytes(1).bytes(std::int64_t{1});
    for (const std::int64_t number : {1, 1, 2}) file.bytes(number);
    file.bytes(2).bytes(1).bytes(2).bytes(std::int64_t{1});
    for (const std::int64_t number : {2, 1, 2, 3}) file.bytes(number);
    file.text("\n$EndElements\n");
    const SurfaceMesh mesh = parse_msh_surface(file.str(), "m.msh");
    CHECK(mesh.vertices == rows<Points3>({0, 0, 0, 1, 0, 0, 0, 1, 0}));
    CHECK(mesh.triangles == rows<Triangles>({0, 1, 2}));
  }
}

TEST_CASE("MSH: faults are named by line") {
  refused("", "m.msh:1: not an MSH file: it does not begin with $MeshFormat");
  refused("$MeshFormat\n1 0 8\n", "m.msh:2: version '1' is none of 2.0 to 2.2, 4.0 and 4.1");
  refused("$MeshFormat\n2.2 2 8\n", "m.msh:2: file type 2 is neither 0 nor 1");
  refused("$MeshFormat\n2.2 0 4\n", "m.msh:2: data size is not 8");
  refused("$MeshFormat\n2.2 0 8\nx\n", "m.msh:3: $EndMeshFormat expected, not 'x'");
  refused(head2, "m.msh:3: no triangles");
  refused(head2 + "12\n", "m.msh:4: section expected, not '12'");
  refused(head2 + "$Comments\n", "m.msh:4: section '$Comments' does not end");
  refused(head2 + "$Elements\n1\n1 2 0 1 2 3\n$EndElements\n", "m.msh:4: elements before nodes");
  refused(head2 + "$Nodes\n9\n1 0 0 0\n$EndNodes\n",
          "m.msh:5: number of nodes 9 is more than the file can hold");
  refused(head2 + "$Nodes\n-9\n", "m.msh:5: number of nodes is negative: -9");
  refused(head2 + "$Nodes\n2\n1 0 0 0\n2 0 0\n$EndNodes\n", "m.msh:7: missing z coordinate");
  refused(head2 + "$Nodes\n2\n1 0 0 0\n$EndNodes\n", "m.msh:7: node expected, not '$EndNodes'");
  refused(head2 + "$Nodes\n1\n1 0 0 0\n2 0 0 0\n$EndNodes\n", "m.msh:7: $EndNodes expected, not '2'");
  refused(head2 + "$Nodes\n1\n1 0 inf 0\n$EndNodes\n", "m.msh:6: y coordinate 'inf' is not finite");
  refused(head2 + "$Nodes\n1\n1 0 0 0\n", "m.msh:6: the file ends where $EndNodes should be");
  refused(head2 + "$Nodes\n3\n1 0 0 0\n2 0 0 0\n1 0 0 0\n$EndNodes\n$Elements\n",
          "m.msh:10: node 1 for the second time");
  refused(head2 + nodes2 + "$Elements\n1\n1 2 0 1 2 3\n$EndElements\n" + nodes2,
          "m.msh:15: nodes after elements");
  refused(head2 + nodes2 + "$Elements\n1\n1 2 0 1 2 5\n$EndElements\n",
          "m.msh:13: node 5 is not in the file");
  refused(head2 + nodes2 + "$Elements\n1\n1 2 0 1 2 -1\n$EndElements\n",
          "m.msh:13: node -1 is not in the file");
  refused(head2 + nodes2 + "$Elements\n1\n1 2 0 1 2\n$EndElements\n", "m.msh:13: missing node");
  refused(head2 + nodes2 + "$Elements\n1\n1 2 99 1 2 3\n$EndElements\n",
          "m.msh:13: number of tags 99 is more than the file can hold");
  refused(head2 + nodes2 + "$Elements\n0\n$EndElements\n", "m.msh:13: no triangles");
  refused(head2 + nodes2 + "$Elements\n1\n1 4 0 1 2 3 4\n$EndElements\n",
          "m.msh:14: no triangles: a mesh of 1 tetrahedron, to be read as such");
  refused(head2 + nodes2 + "$Elements\n1\n1 5 0 1 2 3 4\n$EndElements\n",
          "m.msh:14: no triangles: a mesh of 1 hexahedron, to be read as such");
  refused(head4 + "$Nodes\n1 2 1 2\n4 1 0 1\n1\n0 0 0\n$EndNodes\n", "m.msh:6: entity of dimension 4");
  refused(head4 + "$Nodes\n1 2 1 2\n2 1 0 1\n1\n0 0 0\n$EndNodes\n", "m.msh:9: 1 nodes instead of 2");
}

TEST_CASE("MSH: faults in binary data are named by byte") {
  const auto start = [](std::int32_t one) {
    return Contents().text("$MeshFormat\n2.2 1 8\n").bytes(one).text("\n$EndMeshFormat\n").str();
  };
  refused(start(2), "m.msh: byte 20: a number 1 should follow the format");
  refused(start(1) + "$Nodes\n1\n" + std::string(10, '\0'),
          "m.msh: byte 47: number of nodes 1 is more than the file can hold");
  const std::string nodes = Contents()
                                .text(start(1) + "$Nodes\n1\n")
                                .bytes(7)
                                .bytes(0.)
                                .bytes(0.)
                                .bytes(0.)
                                .text("\n$EndNodes\n$Elements\n")
                                .str();
  const std::string place = "m.msh: byte " + std::to_string(nodes.size() + 2) + ": ";
  const auto elements = [&](std::int32_t type, std::int32_t count, std::int32_t tags) {
    return Contents()
        .text(nodes + "2\n")
        .bytes(type)
        .bytes(count)
        .bytes(tags)
        .bytes(1)
        .bytes(7)
        .bytes(7)
        .bytes(8)
        .str();
  };
  const auto at = [&](std::size_t offset, const char* what) {
    return "m.msh: byte " + std::to_string(nodes.size() + 2 + offset) + ": " + what;
  };
  refused(elements(2, 1, 0), at(24, "node 8 is not in the file").c_str());
  refused(elements(2, 3, 0), at(8, "3 elements where 2 are left").c_str());
  refused(elements(2, 0, 0), at(8, "0 elements where 2 are left").c_str());
  refused(elements(2, 2, 0), at(8, "the file ends within the elements").c_str());
  refused(elements(200, 1, 0), at(0, "elements of unknown type 200").c_str());
  refused(elements(2, 1, 1000), at(8, "number of tags 1000 is more than the file can hold").c_str());
}
