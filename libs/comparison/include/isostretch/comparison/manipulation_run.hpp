#pragma once

#include <isostretch/comparison/manipulation_report.hpp>
#include <isostretch/core/monitor.hpp>
#include <isostretch/core/output_folder.hpp>
#include <isostretch/core/timer.hpp>
#include <isostretch/figures/animation.hpp>
#include <isostretch/figures/photo_frames.hpp>

#include <filesystem>
#include <optional>
#include <string>
#include <utility>

namespace isostretch::comparison {

/// The options of a run that change no result.
struct ManipulationRunOptions {
  int first = 1;                             ///< Number of the first frame to make.
  int last = 1;                              ///< Number of the last one.
  double time_limit = 0;                     ///< Seconds for all frames; 0: no limit.
  double memory_limit = 0;                   ///< Megabytes that a rival's process may take; 0: no limit.
  bool picture = true;                       ///< Whether pictures and report.html are written.
  bool glb = false;                          ///< Whether manipulate.glb is written.
  int threads = 1;                           ///< Threads of the parallel loops, for the summary.
  std::string name = {};                     ///< Title of the reports.
  std::filesystem::path weights_cache = {};  ///< Folder that keeps handle weights; empty: none.
};

/// The manipulation of a scene from its weights to the reports, in a folder: a file for every frame as soon
/// as it is made, trace.csv, summary.json, pictures and report.html. Warnings and a line for every frame go
/// to the log.
class ManipulationRun {
 public:
  /// Computes or reads the weights of the handles. All references must outlive this object; `seconds` has
  /// what reading took, and `timer` began with it. Throws Error where a handle cannot have weights.
  ManipulationRun(const scene::ManipulationScene& scene, const deformation::SolidModel& body,
                  const deformation::HandleSet& handle_set, ManipulationRunOptions options,
                  ManipulationSeconds seconds, const Timer& timer);

  /// Lets a picture follow the frames.
  void add_photo(figures::PhotoFrames photo) { photo_.emplace(std::move(photo)); }

  /// Makes the frames and adds all files, which appear when the caller commits; frames appear at once. The
  /// token of the monitor ends it after an iteration, and what was made by then is reported on.
  void run(OutputFolder& folder, const Monitor& monitor);

  /// Returns what came of it.
  const ManipulationReport& report() const { return report_; }

 private:
  void warn(const std::string& text);
  void write_rest(OutputFolder& folder);
  void write_frame(OutputFolder& folder, const std::string& file, const Vector& positions,
                   const StrainedShape& shape) const;
  void make_frames(OutputFolder& folder, const Monitor& monitor);
  void take(ManipulationFrame made, OutputFolder& folder);
  void write_photos(OutputFolder& folder);
  void write_pictures(OutputFolder& folder);
  void write_reports(OutputFolder& folder);

  const scene::ManipulationScene& scene_;
  const deformation::SolidModel& body_;
  ManipulationRunOptions options_;
  ManipulationSeconds seconds_;
  const Timer& timer_;
  deformation::ElementRotations rotations_;
  ManipulationReport report_;
  deformation::Strain strain_;
  figures::Animation animation_;
  std::optional<figures::PhotoFrames> photo_;
  std::string states_, path_;  // pictures
};

/// Returns the picture that "photo" of a scene lays on a flat body; none where there is none. Its file is
/// sought from `folder`. Throws Error naming the key, or the file.
std::optional<figures::PhotoFrames> read_photo(const scene::ManipulationScene& scene,
                                               const deformation::SolidModel& body,
                                               const std::filesystem::path& folder);

}  // namespace isostretch::comparison
