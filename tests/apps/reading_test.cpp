// Files as other programs write them, read by the apps: kinds of elements, groups, planes, repair, welding,
// OBJ kept.
#include "deform_app.hpp"
#include "failure.hpp"
#include "interpolate_app.hpp"
#include "manipulate_app.hpp"

#include <isostretch/mesh_io/io.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <string>
#include <vector>

using namespace isostretch;
using namespace isostretch::test;
using doctest::Approx;
using Json = nlohmann::ordered_json;

namespace {

const std::string medit =
    "MeshVersionFormatted 2\nDimension 3\nVertices\n5\n0 0 0 0\n1 0 0 0\n0 1 0 0\n0 0 1 0\n";
const std::string mixed_orientation = medit + "1 1 1 0\nTetrahedra\n2\n1 2 3 4 1\n2 3 5 4 1\nEnd\n";
const std::string there_twice = medit + "1 1 1 0\nTetrahedra\n3\n1 2 3 4 1\n2 5 3 4 1\n2 3 1 4 1\nEnd\n";
const std::string isolated = medit + "9 9 9 0\nTetrahedra\n1\n1 2 3 4 1\nEnd\n";
const std::string tagged =
    "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n2\n3 1 \"soft\"\n3 2 \"bone\"\n$EndPhysicalNames\n"
    "$Nodes\n5\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n5 1 1 1\n$EndNodes\n"
    "$Elements\n2\n1 4 2 1 1 1 2 3 4\n2 4 2 2 2 2 5 3 4\n$EndElements\n";

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

std::vector<std::string> pulled(const std::string& file, const Scratch& scratch) {
  return {file,
          "-o",
          scratch.path("out"),
          "--handle",
          "slab:z,min,0.01",
          "--handle",
          "slab:z,max,0.01;translate=0.5,0,0",
          "--no-picture",
          "--frames",
          "1"};
}

nlohmann::json mesh_of(const Scratch& scratch) {
  return read_json(scratch.path("out/summary.json")).at("mesh");
}

// Every app that reads a body says the same of it.
void refused(const std::string& contents, const std::vector<std::string>& words) {
  const Scratch scratch;
  const std::string file = scratch.write("body.mesh", contents);
  check_failure_of([](const auto& list) { return deform(list); }, scratch, pulled(file, scratch), 3, words);
  check_failure_of([](const auto& list) { return manipulate(list); }, scratch, pulled(file, scratch), 3,
                   words);
  check_failure_of([](const auto& list) { return interpolate(list); }, scratch,
                   {file, file, "-o", scratch.path("out"), "--no-picture"}, 3, words);
}

// And --repair mends it in every one.
void repaired(const std::string& contents, const std::string& notice) {
  const Scratch scratch;
  const std::string file = scratch.write("body.mesh", contents);
  std::vector<std::string> arguments = pulled(file, scratch);
  arguments.push_back("--repair");
  for (const auto& app : {std::function(deform), std::function(manipulate)}) {
    const Outcome run = app(arguments, {});
    CHECK_MESSAGE(run.code == 0, run.err);
    CHECK_MESSAGE(has(run.err, notice), run.err);
    CHECK(mesh_of(scratch).at("elements") == 2);
    CHECK(mesh_of(scratch).at("volume").get<double>() == Approx(0.5));
  }
  const Outcome run = interpolate({file, file, "-o", scratch.path("way"), "--no-picture", "--repair"});
  CHECK_MESSAGE(run.code == 0, run.err);
  CHECK(has(run.err, notice));
}

}  // namespace

TEST_CASE("bodies: elements numbered the other way round or there twice are refused by name, or repaired") {
  refused(mixed_orientation, {"body.mesh: tet 1 (vertices 1 2 4 3) has negative volume", "--repair turns"});
  repaired(mixed_orientation, "repair: 1 tet turned: 1");
  refused(there_twice, {"body.mesh: tet 2 (vertices 1 2 0 3) is there twice", "--repair leaves out copies"});
  repaired(there_twice, "repair: 1 tet there twice, left out: 2");
}

TEST_CASE("bodies: an element of two physical groups is one") {
  const Scratch scratch;
  std::string text = tagged;
  text.replace(text.find("$Elements"), std::string::npos,
               "$Elements\n4\n1 4 2 1 1 1 2 3 4\n2 4 2 2 1 1 2 3 4\n3 4 2 1 1 2 5 3 4\n4 4 2 2 1 2 5 3 "
               "4\n$EndElements\n");
  const std::string file = scratch.write("body.msh", text);
  for (const auto& app : {std::function(deform), std::function(manipulate)}) {
    const Outcome run = app(pulled(file, scratch), {});
    CHECK_MESSAGE(run.code == 0, run.err);
    CHECK(mesh_of(scratch).at("elements") == 2);
    CHECK(mesh_of(scratch).at("volume").get<double>() == Approx(0.5));
  }
}

TEST_CASE("bodies: vertices of no element are neither selected nor part of extents") {
  const Scratch scratch;
  const std::string file = scratch.write("body.mesh", isolated);
  for (const auto& app : {std::function(deform), std::function(manipulate)}) {
    const Outcome run = app(pulled(file, scratch), {});
    CHECK_MESSAGE(run.code == 0, run.err);
    CHECK(mesh_of(scratch).at("diagonal").get<double>() == Approx(std::sqrt(3.0)));
    const Json handle = read_json(scratch.path("out/summary.json")).at("handles").at(1);
    CHECK(handle.at("nodes") == 1);
    std::vector<std::string> alone = pulled(file, scratch);
    alone[6] = "vertices:4;translate=0.5,0,0";
    check_failure_of([&](const auto& list) { return app(list, {}); }, scratch, alone, 2,
                     {"handles[1].select: selects no vertex of an element: vertex 4 belongs to none"});
    alone[6] = "sphere:9,9,9,1";
    check_failure_of([&](const auto& list) { return app(list, {}); }, scratch, alone, 2,
                     {"handles[1].select: selects no vertex"});
  }
}

TEST_CASE("groups: by name and number in handles and regions, unknown ones listed") {
  const Scratch scratch;
  const std::string file = scratch.write("body.msh", tagged);
  Outcome run = deform({file, "-o", scratch.path("out"), "--handle", "group:bone;translate=0,0,0.1",
                        "--handle", "nearest:0,0,0", "--no-picture", "--frames", "1"});
  CHECK_MESSAGE(run.code == 0, run.err);
  CHECK(read_json(scratch.path("out/summary.json")).at("handles").at(0).at("nodes") == 4);
  Json scene = {{"mesh", "body.msh"},
                {"energy", "arap"},
                {"regions", {{{"select", {{"group", "bone"}}}, {"energy", "symmetric_dirichlet"}}}},
                {"handles", {{{"select", {{"nearest", {{"point", {0, 0, 0}}}}}}}}},
                {"frames", 1}};
  run = deform({write_scene(scratch, scene), "-o", scratch.path("out"), "--no-picture"});
  CHECK_MESSAGE(run.code == 0, run.err);
  CHECK(read_json(scratch.path("out/summary.json")).at("regions").at(0).at("elements") == 1);
  // A group of faces holds vertices, and no elements.
  std::string with_face = tagged;
  with_face.replace(with_face.find("$Elements"), std::string::npos,
                    "$Elements\n3\n1 4 2 1 1 1 2 3 4\n2 4 2 2 2 2 5 3 4\n3 2 2 7 1 1 2 3\n$EndElements\n");
  const std::string faces = scratch.write("faces.msh", with_face);
  run = deform({faces, "-o", scratch.path("out"), "--handle", "group:7", "--handle",
                "nearest:1,1,1;translate=0,0,0.1", "--no-picture", "--frames", "1"});
  CHECK_MESSAGE(run.code == 0, run.err);
  CHECK(read_json(scratch.path("out/summary.json")).at("handles").at(0).at("nodes") == 3);
  Json of_faces = scene;
  of_faces["mesh"] = "faces.msh";
  of_faces["regions"][0]["select"]["group"] = 7;
  check_failure_of([](const auto& list) { return deform(list); }, scratch,
                   {write_scene(scratch, of_faces, "faces.json"), "-o", scratch.path("new"), "--no-picture"},
                   3, {"regions[0].select: the group '7' is one of faces, lines or points"});
  scene["regions"][0]["select"]["group"] = 2;
  CHECK(deform({write_scene(scratch, scene), "-o", scratch.path("out"), "--no-picture"}).code == 0);
  scene["regions"][0]["select"]["group"] = "bony";
  write_scene(scratch, scene);
  check_failure_of([](const auto& list) { return deform(list); }, scratch,
                   {scratch.path("scene.json"), "-o", scratch.path("new"), "--no-picture"}, 3,
                   {"regions[0].select: there is no group 'bony'; there are 1 'soft', 2 'bone'"});
}

TEST_CASE("bodies: hexahedra, elements of second order and TetGen's files; several kinds are refused") {
  const Scratch scratch;
  const std::string grid =
      "# vtk DataFile Version 3.0\nt\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 9 double\n"
      "0 0 0 1 0 0 1 1 0 0 1 0\n0 0 1 1 0 1 1 1 1 0 1 1\n0.5 0.5 2\n";
  const std::string hex = scratch.write("hex.vtk", grid + "CELLS 1 9\n8 0 1 2 3 4 5 6 7\nCELL_TYPES 1\n12\n");
  CHECK(deform(pulled(hex, scratch)).code == 0);
  CHECK(mesh_of(scratch).at("element") == "hex");
  CHECK(mesh_of(scratch).at("volume").get<double>() == Approx(1));
  // What was written is read again.
  CHECK(deform(pulled(scratch.path("out/frame_0000.vtu"), scratch)).code == 0);
  CHECK(mesh_of(scratch).at("element") == "hex");
  const std::string mixed = scratch.write(
      "mixed.vtk", grid + "CELLS 3 19\n8 0 1 2 3 4 5 6 7\n4 4 5 6 8\n4 4 6 7 8\nCELL_TYPES 3\n12\n10\n10\n");
  check_failure_of([](const auto& list) { return deform(list); }, scratch,
                   {mixed, "-o", scratch.path("new"), "--handle", "nearest:0,0,1"}, 3,
                   {"mixed.vtk:16: 2 tetrahedra and 1 hexahedron: a body is of one kind"});
  const std::string second =
      scratch.write("second.msh",
                    "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n10\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n5 "
                    ".5 0 0\n6 .5 .5 0\n"
                    "7 0 .5 0\n8 0 0 .5\n9 0 .5 .5\n10 .5 0 .5\n$EndNodes\n$Elements\n1\n1 11 2 1 1 1 2 3 4 "
                    "5 6 7 8 9 10\n$EndElements\n");
  CHECK(deform(pulled(second, scratch)).code == 0);
  CHECK(mesh_of(scratch).at("element") == "quadratic tet");
  CHECK(mesh_of(scratch).at("volume").get<double>() == Approx(1.0 / 6));
  scratch.write("t.node", "5 3 0 0\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n5 1 1 1\n");
  scratch.write("t.ele", "2 4 0\n1 1 2 3 4\n2 2 5 3 4\n");
  CHECK(deform(pulled(scratch.path("t.ele"), scratch)).code == 0);
  CHECK(mesh_of(scratch).at("volume").get<double>() == Approx(0.5));
}

TEST_CASE("flat bodies lie in any plane, and frames in the same") {
  const Scratch scratch;
  std::string axes;  // what a run says of them
  const auto frame = [&](const std::string& model) {
    const std::string file = scratch.write("plane.obj", model + "f 1 2 3\nf 1 3 4\n");
    const Outcome run = deform({file, "-o", scratch.path("out"), "--handle", "slab:x,min,0.01", "--handle",
                                "slab:x,max,0.01;rotate=30;translate=0.2,0.1", "--no-picture", "--frames",
                                "1", "--format", "obj"});
    CHECK_MESSAGE(run.code == 0, run.err);
    axes = run.err;
    CHECK(mesh_of(scratch).at("area").get<double>() == Approx(1));
    const mesh::SurfaceMesh first = mesh::read_obj(scratch.path("out/frame_0000.obj"));
    CHECK((first.vertices - mesh::read_obj(file).vertices).cwiseAbs().maxCoeff() < 1e-6);
    return std::array{first, mesh::read_obj(scratch.path("out/frame_0001.obj"))};
  };
  for (const mesh::SurfaceMesh& m : frame("v 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n"))
    CHECK((m.vertices.col(2).array() == 1).all());
  CHECK(axes.find("runs along") == std::string::npos);
  for (const mesh::SurfaceMesh& m : frame("v 0 0 0\nv 1 0 1e-12\nv 1 1 0\nv 0 1 -1e-12\n"))
    CHECK(m.vertices.col(2).cwiseAbs().maxCoeff() < 1e-11);
  for (const mesh::SurfaceMesh& m : frame("v 5 0 0\nv 5 1 0\nv 5 1 1\nv 5 0 1\n"))
    CHECK(m.vertices.col(0).isApproxToConstant(5, 1e-12));
  CHECK_MESSAGE(
      axes.find("plane.obj: flat, in a plane of its own: x of the scene runs along (0, 1, 0) of the file "
                "and y along (0, 0, 1)") != std::string::npos,
      axes);
  frame("v 5 0 0\nv 5 0 1\nv 5 1 1\nv 5 1 0\n");  // faces the other way
  CHECK_MESSAGE(axes.find("along (0, 1, 0) of the file and y along (0, 0, -1)") != std::string::npos, axes);
  // Across x + y + z = 1, either way round.
  const std::string a = "v 1 0 0\n", b = "v 0.2928932188134524 0.7071067811865476 0\n";
  const double s = 1 / std::sqrt(6.0);
  std::string c, d;
  for (auto [text, x, y] : {std::tuple(&c, 0.2928932188134524, 0.7071067811865476), std::tuple(&d, 1.0, 0.0)})
    *text = "v " + Json(x - s).dump() + " " + Json(y - s).dump() + " " + Json(2 * s).dump() + "\n";
  for (const auto& m : {frame(a + b + c + d), frame(d + c + b + a)}) {
    CHECK(m[0].vertices.rowwise().sum().isApproxToConstant(1, 1e-6));
    CHECK(m[1].vertices.rowwise().sum().isApproxToConstant(1, 1e-6));
    CHECK((m[1].vertices - m[0].vertices).cwiseAbs().maxCoeff() > 0.1);
  }
  const std::string bent =
      scratch.write("bent.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0.3\nv 0 1 0\nf 1 2 3\nf 1 3 4\n");
  check_failure_of([](const auto& list) { return deform(list); }, scratch,
                   {bent, "-o", scratch.path("new"), "--handle", "all"}, 3,
                   {"bent.obj: a surface is deformed in its plane, but vertex "});
}

TEST_CASE("scenes: a key that is given twice is an error with its path") {
  const Scratch scratch;
  for (const auto& [text, path] : {std::pair("{\"mesh\": 1, \"frames\": 2, \"frames\": 3}",
                                             "scene.json: frames: the key is given twice"),
                                   {"{\"handles\": [{}, [], {\"select\": {\"a\": 1, \"a\": 2}}]}",
                                    "scene.json: handles[2].select.a: the key is given twice"},
                                   {"{\"a\": [[1, {\"b\": 1, \"c\": {\"b\": 3}, \"b\": 2}]]}",
                                    "scene.json: a[0][1].b: the key is given twice"}})
    check_failure_of([](const auto& list) { return deform(list); }, scratch,
                     {scratch.write("scene.json", text), "-o", scratch.path("out")}, 3, {path});
}

TEST_CASE(
    "OBJ: groups, materials, normals, colours and polygons are kept, uv is written to the original faces") {
  const Scratch scratch;
  const std::string head =
      "mtllib a.mtl\no thing\nv 0 0 0 1 0 0\nv 1 0 0 0 1 0\nv 1 1 0.2 0 0 1\nv 0 1 0 1 1 0\nv 2 0 0\n"
      "vn 0 0 1\ng left\nusemtl red\ns 1\n";
  const std::string file =
      scratch.write("m.obj", head + "f 1//1 2//1 3//1 4//1\ng right\nusemtl blue\nf 2//1 5//1 3//1\n");
  const Outcome run = parameterize({file, "-o", scratch.path("out"), "--no-picture"});
  CHECK_MESSAGE(run.code == 0, run.err);
  CHECK(has(run.err, "their files are not copied"));
  const std::string text = read_file(scratch.path("out/m_uv.obj"));
  CHECK(text.rfind(head + "vt ", 0) == 0);
  CHECK(has(text, "\nf 1/1/1 2/2/1 3/3/1 4/4/1\ng right\nusemtl blue\nf 2/2/1 5/5/1 3/3/1\n"));
}

TEST_CASE("OBJ: --repair leaves faces out of the file as it was, and says when it cannot") {
  const Scratch scratch;
  const std::string points = "v 0 0 0\nv 1 0 0.1\nv 1 1 0.3\nv 0 1 0\n";
  std::string file = scratch.write("m.obj", points + "f 1 2\ng a\nf 1 2 3\nf 1 2 3\ng b\nf 1 3 4\n");
  check_failure_of([](const auto& list) { return parameterize(list); }, scratch,
                   {file, "-o", scratch.path("out")}, 3,
                   {"m.obj:5: face with 2 vertices; --repair leaves it out"});
  Outcome run = parameterize({file, "-o", scratch.path("out"), "--no-picture", "--repair"});
  CHECK_MESSAGE(run.code == 0, run.err);
  CHECK(has(run.err, "1 face(s) of less than three vertices left out"));
  CHECK(has(read_file(scratch.path("out/m_uv.obj")), "g a\nvt "));
  CHECK(mesh::read_obj(scratch.path("out/m_uv.obj")).triangles.rows() == 2);
  file = scratch.write("m.obj", points + "g a\nf 1 2 3\nf 1 4 3\n");
  run = parameterize({file, "-o", scratch.path("out"), "--no-picture", "--repair"});
  CHECK_MESSAGE(run.code == 0, run.err);
  CHECK(has(run.err, "groups, materials, normals and polygons are not kept"));
}

TEST_CASE("welding: coinciding points are told of, and taken for one where asked to, in every format") {
  const Scratch scratch;
  const std::string corners = "0 0 0\n1 0 0.1\n1 1 0.3\n0 0 0\n1 1 0.3000001\n0 1 0\n";
  std::string obj, rest = corners;
  for (; !rest.empty(); rest = rest.substr(rest.find('\n') + 1))
    obj += "v " + rest.substr(0, rest.find('\n') + 1);
  const std::string exact = [&] {
    std::string text = obj;
    return text.replace(text.find("0.3000001"), 9, "0.3");
  }();
  const std::string faces = "f 1 2 3\nf 4 5 6\n";
  for (const auto& [name, text] :
       {std::pair(std::string("m.obj"), obj + faces),
        {"m.off", "OFF\n6 2 0\n" + corners + "3 0 1 2\n3 3 4 5\n"},
        {"m.ply",
         "ply\nformat ascii 1.0\nelement vertex 6\nproperty float x\nproperty float y\nproperty float z\n"
         "element face 2\nproperty list uchar int vertex_indices\nend_header\n" +
             corners + "3 0 1 2\n3 3 4 5\n"}}) {
    const std::string file = scratch.write(name, text);
    const auto charts = [&](std::vector<std::string> more) {
      more.insert(more.begin(), {file, "-o", scratch.path("out"), "--no-picture"});
      const Outcome run = parameterize(more);
      CHECK_MESSAGE(run.code == 0, run.err);
      return read_json(scratch.path("out/summary.json")).at("mesh").at("components").get<int>();
    };
    CHECK(charts({}) == 2);
    CHECK(charts({"--weld=1e-3"}) == 1);
  }
  const std::string file = scratch.write("m.obj", exact + faces);
  Outcome run = parameterize({file, "-o", scratch.path("out"), "--no-picture"});
  CHECK(has(
      run.err,
      "2 vertices are at the place of others, so that the surface comes in 2 pieces instead of 1; --weld"));
  run = parameterize({"--weld", file, "-o", scratch.path("out"), "--no-picture"});
  CHECK_MESSAGE(run.code == 0, run.err);
  CHECK(has(run.err, "weld: 2 vertices taken for others"));
  // The file keeps its vertices.
  CHECK(mesh::read_obj(scratch.path("out/m_uv.obj")).vertices.rows() == 6);
  check_failure_of([](const auto& list) { return parameterize(list); }, scratch,
                   {file, "-o", scratch.path("new"), "--weld=-1"}, 2, {"--weld: '-1' is no tolerance"});
}

TEST_CASE("PLY: uv of the file is a start and has seams") {
  const Scratch scratch;
  const std::string head =
      "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n";
  const std::string faces = "element face 2\nproperty list uchar int vertex_indices\n";
  const std::string at_vertices = scratch.write(
      "v.ply", head + "property float s\nproperty float t\n" + faces +
                   "end_header\n0 0 0 0 0\n1 0 0.1 1 0\n1 1 0.3 1 1\n0 1 0 0 1\n3 0 1 2\n3 0 2 3\n");
  const std::string with_seam = scratch.write(
      "f.ply", head + faces +
                   "property list uchar float texcoord\nend_header\n0 0 0\n1 0 0.1\n1 1 0.3\n0 1 0\n"
                   "3 0 1 2 6 0 0 1 0 1 1\n3 0 2 3 6 5 5 6 6 5 6\n");
  for (const std::string& file : {at_vertices, with_seam}) {
    const Outcome run = parameterize({file, "-o", scratch.path("out"), "--no-picture", "--initial", "input"});
    CHECK_MESSAGE(run.code == 0, run.err);
  }
  const Outcome run = parameterize({with_seam, "-o", scratch.path("out"), "--no-picture"});
  CHECK_MESSAGE(has(run.err, "cut along the input's seams: 1 edge, 2 charts"), run.err);
}
