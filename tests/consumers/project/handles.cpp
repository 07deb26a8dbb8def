// A strip of triangles with one end turned by a quarter, and the rest carried along: by displacements, and by
// rotations blended with the weights of both ends.
#include "expect.hpp"

#include <isostretch/handles/extension.hpp>
#include <isostretch/handles/motion.hpp>
#include <isostretch/handles/rotation_blend.hpp>

#include <cmath>
#include <vector>

using namespace isostretch;

namespace {

constexpr int squares = 4;

assembly::Elements strip() {
  assembly::Elements elements;
  elements.dim = 2;
  elements.nodes_per_element = 3;
  elements.points_per_element = 1;
  elements.node_count = 2 * squares + 2;
  for (int i = 0; i < 2 * squares; i += 2) {
    elements.nodes.insert(elements.nodes.end(), {i, i + 2, i + 1, i + 1, i + 2, i + 3});
    elements.gradients.insert(elements.gradients.end(), {-1, -1, 1, 0, 0, 1, -1, 0, 0, -1, 1, 1});
    elements.weights.insert(elements.weights.end(), {0.5, 0.5});
  }
  return elements;
}

}  // namespace

int main() {
  handles::Nodes nodes;
  nodes.dim = 2;
  nodes.positions.resize(4 * squares + 4);
  for (int i = 0; i < nodes.positions.size() / 2; ++i) nodes.positions.segment<2>(2 * i) << i / 2, i % 2;
  const auto low = handles::select(handles::Slab{0, handles::End::min, 0.01}, nodes, "low");
  const auto high = handles::select(handles::Slab{0, handles::End::max, 0.01}, nodes, "high");
  EXPECT(low.size() == 2 && high.size() == 2);

  const handles::Motion turn({{0, {}}, {1, {.degrees = 90}}}, handles::center_of(high, nodes), "high");
  std::vector<int> given = low;
  Vector u = Vector::Zero(nodes.positions.size());
  for (const int n : high) {
    given.push_back(n);
    u.segment<2>(2 * n) = (turn.at(1)(nodes.at(n)) - nodes.at(n)).head<2>();
  }
  EXPECT(u.norm() == 1);  // both by half the root of two
  const Vector extended = handles::Extension(strip(), given, handles::ExtensionKind::biharmonic).extend(u);
  for (const int n : low) EXPECT(extended.segment<2>(2 * n).norm() == 0);
  for (const int n : high) EXPECT((extended - u).segment<2>(2 * n).norm() == 0);
  EXPECT(extended.segment<2>(4).norm() > 0.01);

  const auto weights = handles::bounded_biharmonic_weights(strip(), {low, high});
  for (int n = 0; n < weights.node_count(); ++n)
    EXPECT(std::abs(weights.at(n, 0) + weights.at(n, 1) - 1) < 1e-12);
  const std::vector<double> rotations =
      handles::blended_rotations(strip(), weights, {{}, turn.axis_angle(1)}, handles::default_blend(2));
  EXPECT(rotations.size() == 4 * 2 * squares);
  EXPECT(rotations.front() > 0.9 && rotations.back() < 0.5);
}
