#include <isostretch/core/error.hpp>
#include <isostretch/fem/element_arrays.hpp>
#include <isostretch/handles/elements.hpp>
#include <isostretch/handles/selection.hpp>
#include <isostretch/mesh/generators.hpp>
#include <isostretch/surface/boundary_surface.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <string>

using namespace isostretch;
using namespace isostretch::handles;

namespace {

// 5 x 3 x 3 vertices, one apart.
mesh::TetMesh bar() {
  return mesh::tet_bar(4, 2, 2, 4, 2, 2);
}

Nodes nodes_of(const mesh::TetMesh& tets) {
  Nodes nodes;
  nodes.positions = Vector::Map(tets.vertices.data(), tets.vertices.size());
  const mesh::BoundarySurface surface = mesh::boundary_surface(tets);
  const auto node = [&](Eigen::Index t, int c) {
    return surface.original_vertex[static_cast<std::size_t>(surface.mesh.triangles(t, c))];
  };
  for (Eigen::Index t = 0; t < surface.mesh.triangles.rows(); ++t)
    for (int c = 0; c < 3; ++c) nodes.boundary_edges.push_back({node(t, c), node(t, (c + 1) % 3)});
  return nodes;
}

std::string failure(const Selection& selection) {
  try {
    select(selection, nodes_of(bar()), "handles[3]");
  } catch (const Error& error) {
    return error.what();
  }
  return "nothing thrown";
}

void check_failure(const Selection& selection, const std::string& word) {
  const std::string message = failure(selection);
  CAPTURE(message);
  CHECK(message.rfind("handles[3]: ", 0) == 0);
  CHECK(message.find(word) != std::string::npos);
}

}  // namespace

TEST_CASE("nodes of no element are neither selected nor looked at") {
  Nodes nodes = nodes_of(bar());
  nodes.positions.conservativeResize(nodes.positions.size() + 3);
  nodes.positions.tail(3).setConstant(100);
  nodes.in_elements.assign(46, true);
  nodes.in_elements[45] = false;
  const auto chosen = [&](const Selection& s) { return select(s, nodes, "it"); };
  CHECK(chosen(All{}).size() == 45);
  CHECK(chosen(Slab{0, End::max, 0.1}).size() == 9);
  CHECK(chosen(Nearest{{100, 100, 100}, 1}) == chosen(Nearest{{4, 2, 2}, 1}));
  CHECK(chosen(List{{45, 3}}) == std::vector<int>{3});
  for (const Selection& alone : {Selection(List{{45}}), Selection(Sphere{{100, 100, 100}, 1}),
                                 Selection(Box{{99, 99, 99}, {101, 101, 101}})})
    CHECK_THROWS_WITH_AS(chosen(alone), doctest::Contains("it: selects no vertex"), Error);
  CHECK_THROWS_WITH_AS(chosen(Nearest{{0, 0, 0}, 46}), doctest::Contains("the 46 nearest of 45 vertices"),
                       Error);
}

TEST_CASE("groups by name, and by number where no name is the same") {
  Nodes nodes = nodes_of(bar());
  nodes.groups = {{1, "soft", {3, 1, 3}}, {2, "", {5}}, {3, "2", {7}}};
  const auto chosen = [&](const char* name) { return select(Group{name}, nodes, "it"); };
  CHECK(chosen("soft") == std::vector<int>{1, 3});
  CHECK(chosen("1") == std::vector<int>{1, 3});
  CHECK(chosen("2") == std::vector<int>{7});
  CHECK_THROWS_WITH_AS(chosen("bone"), "it: there is no group 'bone'; there are 1 'soft', 2, 3 '2'", Error);
  CHECK_THROWS_WITH_AS(chosen(""), doctest::Contains("there is no group ''"), Error);
  nodes.groups.clear();
  CHECK_THROWS_WITH_AS(chosen("bone"), "it: there is no group 'bone'; the mesh has none", Error);
}

TEST_CASE("selections of a bar") {
  const Nodes nodes = nodes_of(bar());
  const auto count = [&](const Selection& s) { return select(s, nodes, "it").size(); };
  CHECK(count(All{}) == 45);
  CHECK(count(Box{{0, 0, 0}, {1, 2, 2}}) == 18);
  CHECK(count(Sphere{{2, 1, 1}, 1.0}) == 7);
  CHECK(count(Sphere{{2, 1, 1}, 0.999}) == 1);
  CHECK(count(Slab{0, End::max, 0.1}) == 9);
  CHECK(count(Slab{0, End::max, 0.25}) == 18);
  CHECK(count(Slab{0, End::min, 2.0, false}) == 27);
  CHECK(count(Slab{2, End::max, 0.1}) == 15);
  CHECK(count(Nearest{{0, 0, 0}, 4}) == 4);
  CHECK(select(List{{7, 3, 7}}, nodes, "it") == std::vector<int>{3, 7});
  for (const int n : select(Slab{0, End::max, 0.1}, nodes, "it")) CHECK(nodes.at(n).x() == 4);
}

TEST_CASE("a patch goes along the boundary") {
  const Nodes nodes = nodes_of(bar());
  // The middle of the x = 0 face, the eight around it, and none inside the bar.
  const std::vector<int> patch = select(Patch{{-3, 1, 1}, 1.5}, nodes, "it");
  CHECK(patch.size() >= 7);  // two of the corners are not joined to the middle by a diagonal
  for (const int n : patch) CHECK(nodes.at(n).x() == 0);
  CHECK(select(Patch{{-3, 1, 1}, 0}, nodes, "it").size() == 1);
  for (const int n : select(Patch{{0, 1, 1}, 2}, nodes, "it")) {
    const Point p = nodes.at(n);
    CHECK((p.x() == 0 || p.y() == 0 || p.y() == 2 || p.z() == 0 || p.z() == 2));
  }
}

TEST_CASE("a bone takes the nodes around a segment, its ends included") {
  const Nodes nodes = nodes_of(bar());
  const auto count = [&](const Segment& s) { return select(s, nodes, "it").size(); };
  CHECK(count({{1, 1, 1}, {3, 1, 1}, 0.5}) == 3);
  CHECK(count({{1, 1, 1}, {3, 1, 1}, 1.0}) == 3 * 5 + 2);
  CHECK(count({{3, 1, 1}, {1, 1, 1}, 1.0}) == 3 * 5 + 2);
  CHECK(count({{2, 1, 1}, {2, 1, 1}, 1.0}) == 7);  // a point: a sphere
  CHECK(count({{0, 0, 0}, {4, 2, 2}, 0.1}) == 3);
}

TEST_CASE("in 2D the last coordinate is not looked at") {
  Nodes nodes;
  nodes.dim = 2;
  nodes.positions.resize(6);
  nodes.positions << 0, 0, 1, 0, 0, 1;
  CHECK(select(Sphere{{0, 0, 9}, 0.5}, nodes, "it") == std::vector<int>{0});
  CHECK(select(Box{{0, 0, 5}, {1, 0.5, -5}}, nodes, "it") == std::vector<int>{0, 1});
  CHECK(select(Segment{{0, 0, 3}, {1, 0, -8}, 0.1}, nodes, "it") == std::vector<int>{0, 1});
}

TEST_CASE("what selects nothing or makes no sense is an error that begins with the name") {
  check_failure(Sphere{{9, 9, 9}, 0.1}, "selects no vertex");
  check_failure(List{}, "selects no vertex");
  check_failure(List{{2, 45}}, "no vertex 45");
  check_failure(List{{-1}}, "no vertex -1");
  check_failure(Box{{1, 0, 0}, {0, 1, 1}}, "axis 0");
  check_failure(Sphere{{0, 0, 0}, 0}, "radius");
  check_failure(Slab{3, End::min, 0.1}, "axis 3");
  check_failure(Slab{0, End::min, 0}, "width");
  check_failure(Nearest{{0, 0, 0}, 0}, "count");
  check_failure(Nearest{{0, 0, 0}, 46}, "46");
  check_failure(Patch{{0, 0, 0}, -1}, "distance");
  check_failure(Segment{{9, 9, 9}, {9, 9, 8}, 0.1}, "selects no vertex");
  check_failure(Segment{{0, 0, 0}, {1, 0, 0}, 0}, "distance");
  check_failure(Segment{{0, 0, 0}, {std::nan(""), 0, 0}, 1}, "not finite");
}

TEST_CASE("elements within a selection, and a part of the arrays") {
  const mesh::TetMesh tets = bar();
  const auto elements = assembly::elements_from(mesh::elements(tets));
  const std::vector<int> chosen =
      elements_within(select(Slab{0, End::min, 1.0, false}, nodes_of(tets), "it"), elements);
  CHECK(chosen.size() == 2 * 2 * 6);
  const assembly::Elements part = restricted(elements, chosen);
  part.validate();
  CHECK(part.element_count() == 24);
  double volume = 0;
  for (const double w : part.weights) volume += w;
  CHECK(volume == doctest::Approx(4));
}

TEST_CASE("components of nodes; a node of no element has none") {
  mesh::TetMesh one = mesh::tet_bar(1, 1, 1), two;
  two.vertices.resize(17, 3);
  two.vertices << one.vertices, Eigen::RowVector3d(9, 9, 9), one.vertices.array() + 3;
  two.tets.resize(12, 4);
  two.tets << one.tets, one.tets.array() + 9;
  const std::vector<int> component = component_of_nodes(assembly::elements_from(mesh::elements(two)));
  for (int n = 0; n < 17; ++n) CHECK(component[static_cast<std::size_t>(n)] == (n < 8 ? 0 : n == 8 ? -1 : 1));
}
