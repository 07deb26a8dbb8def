#pragma once

#include <isostretch/figures/canvas.hpp>
#include <isostretch/figures/distortion_scale.hpp>
#include <isostretch/mesh/types.hpp>

#include <string>
#include <vector>

namespace isostretch::figures {

/// A layout in the plane as the plots take it.
struct LayoutData {
  const mesh::Points2& uv;                 ///< V x 2.
  const mesh::Triangles& triangles;        ///< F x 3, indices into uv.
  const std::vector<double>& distortions;  ///< Distortion of every triangle.
  const std::vector<int>& flipped;         ///< Triangles turned over, drawn last and in their own colour.
  const std::vector<int>& pins;            ///< Vertices to mark.
  bool unit_square = false;  ///< Whether to draw the unit square, since charts are packed there.
  const std::vector<int>* overlapping = nullptr;  ///< Triangles that lie on others, hatched.
};

/// Fits the layout into the box and draws it coloured by distortion, with its outline, and with its edges
/// when the triangles are few.
void draw_layout(Canvas& canvas, const Box& box, const LayoutData& data, const DistortionScale& scale);

/// Draws a colour bar with ticks on its left and the histogram of the area, or of what `whole` names, growing
/// to its right.
void draw_distortion_scale(Canvas& canvas, const Box& box, const DistortionScale& scale,
                           const std::string& whole = "area");

}  // namespace isostretch::figures
