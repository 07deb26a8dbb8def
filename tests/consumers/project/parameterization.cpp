// A closed surface flattened into an atlas.
#include "expect.hpp"

#include <isostretch/energies/registry.hpp>
#include <isostretch/mesh/generators.hpp>
#include <isostretch/parameterization/parameterize.hpp>

using namespace isostretch;

int main() {
  // snippet: libs/parameterization/README.md
  const mesh::SurfaceMesh model = mesh::icosphere(4);  // or mesh::read_surface("model.obj")
  parameterization::Options options;
  options.newton.time_limit = 60;
  const auto atlas =
      parameterization::parameterize(model, energies::make_energy("symmetric_dirichlet"), options);
  const mesh::SurfaceMesh textured = atlas.textured();  // the same triangles, uv in the unit square
  // end of snippet
  EXPECT(atlas.succeeded(options));
  EXPECT(textured.triangles == model.triangles);
  EXPECT(textured.uv.minCoeff() >= 0 && textured.uv.maxCoeff() <= 1);
}
