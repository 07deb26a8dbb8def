#pragma once

#include <isostretch/deformation/elastic_problem.hpp>
#include <isostretch/deformation/strain.hpp>

#include <string>

namespace isostretch::figures {

/// The state of a sequence, for its picture.
struct SequenceFigure {
  const deformation::SolidModel& body;         ///< Body at rest.
  const deformation::HandleSet& handle_set;    ///< Handles.
  const deformation::ElasticProblem& problem;  ///< Energies of the regions.
  const Vector& positions;                     ///< Positions in the last frame.
  int frame = 0;                               ///< Number of that frame.
  double time = 0;                             ///< Its time.
  int frames = 0;                              ///< Frames that are wanted.
  long iterations = 0;                         ///< Iterations of all frames together.
};

/// Returns the body at rest, with arrows to where handles go, beside the last frame, with the targets of soft
/// handles, as bytes of a PNG.
std::string draw_sequence(const SequenceFigure& figure);

}  // namespace isostretch::figures
