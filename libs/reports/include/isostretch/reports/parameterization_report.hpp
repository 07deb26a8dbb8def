#pragma once

#include <isostretch/energies/any_energy.hpp>
#include <isostretch/parameterization/parameterize.hpp>
#include <isostretch/reports/run_status.hpp>
#include <isostretch/surface/repair.hpp>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace isostretch::reports {

/// A parameterization with what it was made of: all that its reports say.
struct ParameterizationReport {
  const parameterization::Parameterization& result;  ///< Surface and layout.
  const parameterization::Options& options;          ///< The options it was made with.
  const energies::AnyEnergy& energy;                 ///< The energy that was minimised.
  std::filesystem::path model;                       ///< The file of the surface.
  mesh::RepairReport repairs = {};                   ///< Repairs of the surface, where these were asked for.
  bool repair = false;                               ///< Whether it was asked for.
  std::optional<double> weld = {};                   ///< Tolerance of welding, where that was asked for.
};

/// Returns how it has ended: failed with flipped triangles, not converged where a bound on the distortion is
/// missed.
RunStatus status(const ParameterizationReport& report);

/// Returns what went wrong, in one line; empty when nothing did.
std::string verdict(const ParameterizationReport& report);

/// Returns what came of it, in one line: charts, flips, overlap, stretch, whether it converged.
std::string outcome(const ParameterizationReport& report);

/// Returns what one who wants to use the layout should know before, a sentence each without a full stop.
std::vector<std::string> layout_warnings(const ParameterizationReport& report);

/// Returns the course of the solve as CSV: the columns of newton::trace_table() and the chart of every row.
std::string trace_text(const ParameterizationReport& report);

/// Returns the summary as a JSON text, indented and with a line break at the end: the solve, mesh, layout,
/// charts, distortion, options and times. Numbers that are not finite are null.
std::string summary_text(const ParameterizationReport& report, const RunFacts& facts);

/// Returns a page of HTML that needs nothing else: what the summary has, for people. `model_png` and
/// `layout_png` are the bytes of the pictures.
std::string report_page(const ParameterizationReport& report, const RunFacts& facts,
                        const std::string& model_png, const std::string& layout_png);

}  // namespace isostretch::reports
