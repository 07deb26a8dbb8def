#pragma once

#include <isostretch/comparison/manipulation_frame.hpp>
#include <isostretch/comparison/record.hpp>
#include <isostretch/core/trace.hpp>
#include <isostretch/deformation/handle_misses.hpp>
#include <isostretch/deformation/strain.hpp>
#include <isostretch/reports/run_status.hpp>
#include <isostretch/scene/manipulation_scene.hpp>

#include <string>
#include <utility>
#include <vector>

namespace isostretch::comparison {

/// Seconds of a manipulation.
struct ManipulationSeconds {
  double read = 0;     ///< Mesh and scene.
  double weights = 0;  ///< Weights of the handles.
  double solve = 0;    ///< All frames.
  double write = 0;    ///< Frames and pictures.
  double total = 0;    ///< All of it.
};

/// The positions of a frame with how they strain the body.
struct StrainedShape {
  deformation::StrainField strain;  ///< Strain of the elements.
  std::vector<double> eigenvalues;  ///< The least eigenvalue of S of every element.
  int indefinite = 0;               ///< Elements with one below the margin
};

/// A manipulation with what came of it: all that reports say, frame by frame.
struct ManipulationReport {
  const scene::ManipulationScene& scene;           ///< Its scene.
  const deformation::SolidModel& body;             ///< Its body.
  const deformation::HandleSet& handle_set;        ///< Its handles.
  const deformation::ElementRotations& rotations;  ///< Ex-rotations of its elements.
  std::string name;                                ///< Name of the scene, or of the body.
  bool stopped = false;                            ///< Whether frames are missing
  std::string message = {};                        ///< Why it was stopped
  int wanted = 0;                                  ///< Frames that were asked for.
  std::vector<Record> frames = {};                 ///< The frames in summary.json.
  Trace trace = {};                                ///< The iterations in trace.csv.
  ManipulationFrame last = {};                     ///< The last frame that has positions
  std::vector<std::string> warnings = {};          ///< Warnings that were given.

  /// Returns how it strains the body where the elements are rotated so and the nodes are at `positions`.
  StrainedShape shape(const deformation::Strain& strain, const std::vector<double>& element_rotations,
                      const Vector& positions) const;

  /// Adds the body at rest, which is in that file.
  void add_rest(const deformation::StrainField& strain, const std::string& file);
  /// Adds a frame: `before`, by the unconstrained minimiser, and `after` are not looked at where it has no
  /// positions.
  void add(const ManipulationFrame& frame, const StrainedShape& before, const StrainedShape& after,
           const std::string& file);

  /// Returns what came of a frame that has positions, in one line.
  std::string frame_text(const ManipulationFrame& frame, const StrainedShape& before,
                         const StrainedShape& after) const;
  /// Returns what a certificate does not say of the last frame: handles that are far from where they are to
  /// be, and elements that are nearly flat.
  std::vector<std::string> last_warnings(const deformation::Strain& strain) const;

  /// Returns how far the handles of a frame are from where they are to be.
  std::vector<deformation::HandleMiss> misses(const ManipulationFrame& frame) const;
  /// Returns the files of frames with their times.
  std::vector<std::pair<std::string, double>> files() const;
  /// Returns how it ended.
  reports::RunStatus status() const;
  /// Returns what went wrong or well, in one line.
  std::string verdict() const;
};

/// Returns the text of summary.json. `threads`: of the parallel loops.
std::string summary_text(const ManipulationReport& report, const ManipulationSeconds& seconds, int threads);

/// Returns a page of HTML that needs nothing else. `states` and `path` are pictures as PNG, or empty;
/// `preview` is a part of the page.
std::string report_page(const ManipulationReport& report, const ManipulationSeconds& seconds,
                        const std::string& states, const std::string& path, const std::string& preview);

}  // namespace isostretch::comparison
