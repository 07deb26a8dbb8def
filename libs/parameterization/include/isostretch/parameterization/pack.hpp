#pragma once

#include <isostretch/mesh/types.hpp>

#include <vector>

namespace isostretch::parameterization {

/// The choices of pack().
struct PackOptions {
  /// Free space around every chart and along the border of the square, as a fraction of its side.
  double margin = 1.0 / 256;
  bool rotate = true;  ///< Turns each chart to its smallest enclosing rectangle, lying down.
};

/// The result of packing charts into the unit square.
struct Packing {
  double scale = 1;  ///< Lengths in the square over lengths given.
  /// Share of the square under triangles, where overlapping triangles are counted once.
  double coverage = 0;
};

/// Lays charts side by side into the unit square, all at the same scale, by a skyline of their enclosing
/// rectangles. Every chart is a set of points with its triangles; points are moved in place by rotation,
/// scale and translation. Throws Error for a chart without triangles or with points that are not finite, and
/// when the margins leave no room.
Packing pack(std::vector<mesh::Points2>& charts, const std::vector<mesh::Triangles>& triangles,
             const PackOptions& options = {});

}  // namespace isostretch::parameterization
