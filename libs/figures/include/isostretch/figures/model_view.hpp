#pragma once

#include <isostretch/figures/camera.hpp>
#include <isostretch/figures/surface_model.hpp>

namespace isostretch::figures {

/// The map from the camera's screen to a picture: pixels = scale * screen + shift.
struct Placement {
  double scale = 1;  ///< Pixels per unit of the screen.
  Point shift;       ///< Shift, in pixels.
};

/// A drawn view of a model.
struct ModelView {
  Raster picture;              ///< The picture.
  std::vector<Point> flipped;  ///< Middles of the flipped triangles that are seen, in pixels.
  std::vector<bool> seen;      ///< Whether nothing lies in front of each probe.
};

/// Returns a surface whose vertices lie in the unit ball, drawn two-sided, its inside greyer, with smooth
/// normals and two lights that move with the camera, on a light ground. Probes are points in the same ball.
ModelView draw_view(const ModelData& model, const mesh::Points3& normals, const Camera& camera,
                    const Placement& placement, int width, int height,
                    const mesh::Points3& probes = mesh::Points3(0, 3));

/// The colour of the ground of views.
inline constexpr Color view_ground{0.97, 0.97, 0.975};

}  // namespace isostretch::figures
