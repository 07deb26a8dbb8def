#include "textured_glb.hpp"

#include "checker_square.hpp"
#include "common/figures/checkerboard.hpp"

#include <isostretch/mesh/io.hpp>

namespace isostretch::app::parameterize {

std::string textured_glb(const Result& r) {
  mesh::SurfaceMesh mesh = textured(r);
  mesh.uv /= checker_square(r) * figures::texture_cells;
  // glTF has floats, which are finest around zero; by whole repeats, so that the texture stays where it is.
  const Eigen::RowVector2d repeats = mesh.uv.colwise().minCoeff().array().floor();
  mesh.uv.rowwise() -= repeats;
  return mesh::format_glb(mesh, {.base_color_png = figures::checker_texture()});
}

}  // namespace isostretch::app::parameterize
