#pragma once

#include <isostretch/figures/camera.hpp>
#include <isostretch/figures/surface_model.hpp>

namespace isostretch::figures {

/// How the camera's screen is laid onto a picture: pixels = scale * screen + shift.
struct Placement {
  double scale = 1;
  Point shift;
};

struct ModelView {
  Raster picture;
  std::vector<Point> flipped;  ///< middles of those triangles that are seen, in pixels
  std::vector<bool> seen;      ///< of every probe, whether nothing lies in front of it
};

/// Draws a surface whose vertices lie in the unit ball, two-sided, its inside greyer, with smooth normals and
/// two lights that move with the camera, on a light ground. Probes are points in the same ball.
ModelView draw_view(const ModelData& model, const mesh::Points3& normals, const Camera& camera,
                    const Placement& placement, int width, int height,
                    const mesh::Points3& probes = mesh::Points3(0, 3));

inline constexpr Color view_ground{0.97, 0.97, 0.975};

}  // namespace isostretch::figures
