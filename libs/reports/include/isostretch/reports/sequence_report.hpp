#pragma once

#include <isostretch/deformation/elastic_problem.hpp>
#include <isostretch/deformation/handle_misses.hpp>
#include <isostretch/deformation/sequence.hpp>
#include <isostretch/figures/sequence_figure.hpp>
#include <isostretch/reports/run_status.hpp>
#include <isostretch/scene/value.hpp>

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace isostretch::reports {

/// How a sequence of frames has ended.
enum class SequenceEnd {
  finished,    ///< All frames are made.
  stop_after,  ///< As many frames as this run was to make are made.
  stopped,     ///< Somebody interrupted it, or the time was up.
  failed       ///< A frame could not be reached.
};

/// The sequence that a report is about. All of it must live longer than the report.
struct SequenceInput {
  const scene::Value& scene;                   ///< Scene with what the command line adds.
  const deformation::HandleScript& script;     ///< Times and number of the frames.
  const deformation::SolidModel& body;         ///< Body at rest.
  const deformation::HandleSet& handle_set;    ///< Handles.
  const deformation::ElasticProblem& problem;  ///< Energies of the regions.
};

/// The last good frame of a sequence, from which it goes on.
struct SequenceState {
  int frame = 0;                      ///< Number of the frame; 0 is the rest shape.
  Vector positions;                   ///< Positions in it.
  std::vector<std::string> warnings;  ///< Sentences for the user about going on from it.
};

/// The report on a sequence, frame by frame as it is made.
class SequenceReport {
 public:
  /// Begins without frames.
  explicit SequenceReport(const SequenceInput& input);
  ~SequenceReport();
  /// Takes over the other report, which is left to be destroyed.
  SequenceReport(SequenceReport&&) noexcept;

  /// Adds frame 0, the rest shape, which is written to that file.
  void add_rest(const deformation::StrainField& strain, const std::string& file);
  /// Adds a frame and its trace; one that was not reached may be the last.
  void add_frame(int frame, const deformation::FrameResult& result, const deformation::StrainField& strain,
                 const std::vector<deformation::HandleMiss>& misses, const std::string& file);
  /// Notes that the sequence has ended before its last frame, and why.
  void end(SequenceEnd end, std::string message);
  /// Adds a warning for the summary and the page.
  void add_warning(std::string text);

  /// Returns the content of the file from which read_state() goes on: scene, frames, trace and positions.
  /// Numbers read back to the bit.
  std::string state_text(int frame, const Vector& positions) const;
  /// Reads such a file, and has its frames from then on. Throws Error naming the file when there is none,
  /// what has changed when it belongs to another scene or body, or what is damaged.
  SequenceState read_state(const std::filesystem::path& file);

  /// Returns how it has ended: failed with inverted elements, not converged where a frame is not.
  RunStatus status() const;
  /// Returns what went wrong or well, in one line.
  std::string verdict() const;
  /// Returns the iterations of all frames as CSV.
  const std::string& trace_text() const;
  /// Returns ParaView's list of the files of the frames.
  std::string animation_text() const;
  /// Returns what the picture of the sequence shows, with the positions in the last frame.
  figures::SequenceFigure figure(const Vector& positions) const;
  /// Returns the summary as a JSON text, indented and with a line break at the end.
  std::string summary_text(const RunFacts& facts) const;
  /// Returns a page of HTML that needs nothing else. `picture` is the bytes of a PNG, `preview` a part of a
  /// page, see figures::Animation.
  std::string page(const RunFacts& facts, const std::string& picture, const std::string& preview) const;

 private:
  struct Record;
  std::unique_ptr<Record> record_;
};

}  // namespace isostretch::reports
