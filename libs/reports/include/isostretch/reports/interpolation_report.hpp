#pragma once

#include <isostretch/deformation/interpolation.hpp>
#include <isostretch/deformation/strain.hpp>
#include <isostretch/figures/interpolation_figure.hpp>
#include <isostretch/reports/run_status.hpp>
#include <isostretch/scene/value.hpp>

#include <array>
#include <memory>
#include <string>

namespace isostretch::reports {

/// How an interpolation has ended.
enum class InterpolationEnd {
  finished,  ///< All frames are made.
  stopped,   ///< Somebody interrupted it, or the time was up.
  failed     ///< A solve failed.
};

/// The interpolation that a report is about. All of it must live longer than the report.
struct InterpolationInput {
  const scene::Value& scene;                         ///< Scene with what the command line adds.
  const deformation::InterpolationOptions& options;  ///< Options it was made with.
  const deformation::KeyShapes& key_shapes;          ///< Both shapes.
  const energies::AnyEnergy& energy;                 ///< Energy of the frames.
};

/// The report on an interpolation, frame by frame as it is made.
class InterpolationReport {
 public:
  /// Begins without frames.
  explicit InterpolationReport(const InterpolationInput& input);
  ~InterpolationReport();
  /// Takes over the other report, which is left to be destroyed.
  InterpolationReport(InterpolationReport&&) noexcept;

  /// Adds a frame with its strain against both key shapes, its trace, and its part in the sums.
  void add_frame(const deformation::InterpolationFrame& frame,
                 const std::array<deformation::StrainField, 2>& strains, const std::string& file);
  /// Adds a frame to those that the picture shows, of which it keeps a handful.
  void add_snapshot(figures::Snapshot shot);
  /// Notes that the interpolation has ended before its last frame, and why.
  void end(InterpolationEnd end, std::string message);
  /// Adds a warning for the summary and the page.
  void add_warning(std::string text);

  /// Returns whether the last frame is much further from the one before than frames are elsewhere: the way
  /// has ended in another minimum than the second key shape.
  bool jumps_at_the_end() const;
  /// Returns how it has ended: failed with inverted elements, not converged where a frame is not.
  RunStatus status() const;
  /// Returns what went wrong or well, in one line.
  std::string verdict() const;
  /// Returns the iterations of all frames as CSV.
  const std::string& trace_text() const;
  /// Returns ParaView's list of the files of the frames.
  std::string animation_text() const;
  /// Returns what the pictures of the interpolation show.
  figures::InterpolationFigure figure() const;
  /// Returns the summary as a JSON text, indented and with a line break at the end.
  std::string summary_text(const RunFacts& facts) const;
  /// Returns a page of HTML that needs nothing else. `frames_png` and `energies_png` are the bytes of the
  /// pictures, `preview` is a part of a page, see figures::Animation.
  std::string page(const RunFacts& facts, const std::string& frames_png, const std::string& energies_png,
                   const std::string& preview) const;

 private:
  struct Record;
  std::unique_ptr<Record> record_;
};

}  // namespace isostretch::reports
