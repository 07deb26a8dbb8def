#pragma once

#include <isostretch/core/vector.hpp>
#include <isostretch/deformation/key_shapes.hpp>

#include <string>
#include <vector>

namespace isostretch::figures {

/// A frame of an interpolation as its picture shows it.
struct Snapshot {
  int number = 0;    ///< Number of the frame.
  double time = 0;   ///< Time, 0 at the first key shape and 1 at the second.
  Vector positions;  ///< Positions, dim entries per node.
};

/// Numbers of one frame, of which plots are made.
struct InterpolationPoint {
  double time = 0;         ///< Time of the frame.
  double psi_1 = 0;        ///< Energy above rest from the first key shape.
  double psi_2 = 0;        ///< Energy above rest from the second.
  double energy = 0;       ///< Energy that the frame minimises.
  double min_det_F_1 = 0;  ///< Least det F against the first key shape.
  double min_det_F_2 = 0;  ///< Least det F against the second.
};

/// An interpolation between key shapes, for its pictures.
struct InterpolationFigure {
  const deformation::KeyShapes& key_shapes;  ///< Both shapes.
  std::string energy_name;                   ///< Name of the energy.
  int frames = 0;                            ///< Number of the frame that is the second key shape.
  long iterations = 0;                       ///< Iterations of all frames together.
  std::vector<Snapshot> snapshots;           ///< Frames to draw, see keep_snapshot().
  std::vector<InterpolationPoint> points;    ///< Numbers of every frame.
};

/// Adds a frame to those to draw, of which there is a handful, evenly over the way. The last one stays only
/// until there is a later one, unless it is among those.
void keep_snapshot(std::vector<Snapshot>& snapshots, Snapshot shot, int frames);

/// Returns frames side by side, coloured by the change of length against the first key shape, as bytes of a
/// PNG.
std::string draw_frames(const InterpolationFigure& figure);

/// Returns two plots over time, of the energies and of the smallest determinants, as bytes of a PNG.
std::string draw_energies(const InterpolationFigure& figure);

}  // namespace isostretch::figures
