// A finger-shaped cap embedded without flips, and two copies of it packed.
#include "expect.hpp"

#include <isostretch/mesh/generators.hpp>
#include <isostretch/parameterization/pack.hpp>
#include <isostretch/parameterization/start.hpp>
#include <isostretch/surface/orientation.hpp>

#include <vector>

using namespace isostretch;

int main() {
  const auto cap = mesh::procedural_face(8);
  auto rest = mesh::flat_elements(cap);
  mesh::scale_to_total_weight(rest, 1.0);
  const auto start = parameterization::flip_free_start(cap, rest);
  EXPECT(start.ok());
  EXPECT(start.method == parameterization::StartMethod::uniform);

  std::vector<mesh::Points2> charts{start.uv, start.uv};
  const auto packing = parameterization::pack(charts, {cap.triangles, cap.triangles});
  EXPECT(packing.coverage > 0.2);
  for (const auto& chart : charts) {
    EXPECT(chart.minCoeff() > 0 && chart.maxCoeff() < 1);
    EXPECT(mesh::count_flipped(chart, cap.triangles) == 0);
  }
}
