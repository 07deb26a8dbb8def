// What isostretch-interpolate says of input it cannot use, and its exit codes.
#include "failure.hpp"
#include "interpolate_app.hpp"

#include <doctest/doctest.h>

#include <algorithm>

using namespace isostretch;
using namespace isostretch::test;

namespace {

void check_failure(const Scratch& scratch, const std::vector<std::string>& arguments, int code,
                   const std::vector<std::string>& words) {
  check_failure_of([](const auto& list) { return interpolate(list); }, scratch, arguments, code, words);
}

// Of a bar as the first pose and this one as the second.
void check_second(const mesh::TetMesh& second, const std::vector<std::string>& words) {
  const Scratch scratch;
  mesh::write_tets(scratch.path("a.mesh"), straight_bar());
  mesh::write_tets(scratch.path("b.mesh"), second);
  check_failure(scratch, {scratch.path("a.mesh"), scratch.path("b.mesh"), "-o", scratch.path("out")}, 3,
                words);
}

}  // namespace

TEST_CASE("interpolate: poses that are not of one mesh are exit code 3, with the element") {
  mesh::TetMesh other = straight_bar();
  SUBCASE("an element of other vertices") {
    other.tets.row(17).swap(other.tets.row(18));
    check_second(other, {"b.mesh has tet 17 (vertices", "a.mesh has tet 17 (vertices", "same order"});
  }
  SUBCASE("other counts") {
    check_second(straight_bar(11), {"b.mesh has 192 vertices", "a.mesh has 208 vertices"});
    other.tets.conservativeResize(other.tets.rows() - 2, 4);
    check_second(other, {"b.mesh has 646 tets", "a.mesh has 648 tets"});
  }
  SUBCASE("an element that is inverted") {
    // A vertex of tet 5 beyond its opposite face.
    const Eigen::RowVector3d middle =
        (other.vertices.row(other.tets(5, 0)) + other.vertices.row(other.tets(5, 1)) +
         other.vertices.row(other.tets(5, 2))) /
        3;
    const int top = other.tets(5, 3);
    other.vertices.row(top) = 2 * middle - other.vertices.row(top);
    check_second(other, {"b.mesh: tet", "(vertices"});
  }
}

TEST_CASE("interpolate: tets and triangles do not mix, surfaces are flat, files are there") {
  const Scratch scratch;
  const std::string a = scratch.path("a.msh"), flat = scratch.path("flat.obj"),
                    bent = scratch.path("bent.obj"), out = scratch.path("out");
  mesh::write_tets(a, straight_bar());
  mesh::write_obj(flat, mesh::grid(3, 3));
  mesh::write_obj(bent, mesh::procedural_face(3));
  check_failure(scratch, {a, flat, "-o", out}, 3, {"flat.obj has triangles", "a.msh has tets"});
  check_failure(scratch, {flat, bent, "-o", out}, 3, {"bent.obj: ", "in its plane", "vertex"});
  check_failure(scratch, {a, scratch.path("none.msh"), "-o", out}, 3, {"none.msh"});
  const std::string garbage = scratch.write("garbage.mesh", "MeshVersionFormatted 1\nVertices\n3\n0 0 x");
  check_failure(scratch, {garbage, a, "-o", out}, 3, {"garbage.mesh"});
}

TEST_CASE("interpolate: a wrong command line is exit code 2, a folder that cannot be made 4") {
  const Scratch scratch;
  const std::string a = scratch.path("a.msh"), out = scratch.path("out");
  mesh::write_tets(a, straight_bar());
  check_failure(scratch, {a, "-o", out}, 2, {"second"});
  check_failure(scratch, {a, a}, 2, {"--out"});
  check_failure(scratch, {a, a, "-o", out, "--frames", "0"}, 2, {"--frames", "'0'"});
  check_failure(scratch, {a, a, "-o", out, "-e", "rubber"}, 2, {"unknown energy 'rubber'", "symmetric_arap"});
  check_failure(scratch, {a, a, "-o", out, "-e", "mips_2d"}, 2, {"mips_2d", "3D"});
  check_failure(scratch, {a, a, "-o", out, "-p", "nu=1"}, 2, {"nu"});
  check_failure(scratch, {a, a, "-o", out, "-e", "dirichlet"}, 2, {"'dirichlet'", "minimum at rest"});
  check_failure(scratch, {a, a, "-o", out, "--initial-guess", "rest"}, 2, {"--initial-guess", "extrapolate"});
  check_failure(scratch, {a, a, "-o", a + "/out"}, 4, {"a.msh/out"});
}
