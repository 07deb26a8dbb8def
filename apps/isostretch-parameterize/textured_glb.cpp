#include "textured_glb.hpp"

#include "checker_square.hpp"

#include <isostretch/figures/checkerboard.hpp>
#include <isostretch/mesh_io/io.hpp>

namespace isostretch::app::parameterize {

std::string textured_glb(const Result& r) {
  const double repeats = 1 / (checker_square(r) * figures::texture_cells);
  return mesh::format_glb(r.all.textured(),
                          {.base_color_png = figures::checker_texture(), .repeats = repeats});
}

}  // namespace isostretch::app::parameterize
