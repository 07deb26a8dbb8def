#pragma once

// What check_energy() found, as data and as text.

#include <algorithm>
#include <sstream>
#include <string>
#include <vector>

namespace isostretch::testing {

/// A property of an energy in one dimension, with the worst case over all deformation samples.
struct EnergyCheck {
  int dim;            ///< Dimension, 2 or 3.
  std::string what;   ///< The property.
  double tolerance;   ///< Largest error that passes.
  double worst = 0;   ///< Largest error that was found.
  std::string where;  ///< Category and F of the worst case.
  int samples = 0;    ///< Samples that were checked.

  /// Returns whether the worst error is within the tolerance; NaN is a failure.
  bool ok() const { return worst <= tolerance; }
};

/// Facts about an energy rather than verdicts: it may well have stress at rest, or be convex.
struct EnergyFacts {
  int dim;                        ///< Dimension, 2 or 3.
  double psi_at_rest = 0;         ///< Energy density at rest.
  double stress_at_rest = 0;      ///< |d psi / d sigma| at sigma = 1.
  bool negative_twist = false;    ///< Whether a twist was negative at a sample with det F > 0.
  bool negative_flip = false;     ///< Whether a flip was negative at a sample with det F > 0.
  bool negative_scaling = false;  ///< Whether a scaling eigenvalue was negative at a sample with det F > 0.
};

/// The findings of check_energy().
struct EnergyReport {
  std::string name;                 ///< Name of the energy.
  std::vector<EnergyCheck> checks;  ///< The checks, with their worst cases.
  std::vector<EnergyFacts> facts;   ///< Facts by dimension.

  /// Returns whether all checks pass and there are some.
  bool ok() const {
    return !checks.empty() &&
           std::all_of(checks.begin(), checks.end(), [](const EnergyCheck& c) { return c.ok(); });
  }

  /// Returns checks and facts as text.
  std::string text() const {
    std::ostringstream out;
    out << "energy " << name << (ok() ? ": all checks passed\n" : ": FAILED\n");
    for (const EnergyCheck& c : checks) {
      out << "  " << c.dim << "D " << c.what << ": " << c.worst << " (allowed " << c.tolerance << ", "
          << c.samples << " samples)" << (c.ok() ? "\n" : "  FAILED\n");
      if (!c.ok()) out << "    at " << c.where << "\n";
    }
    for (const EnergyFacts& f : facts)
      out << "  " << f.dim << "D psi at rest " << f.psi_at_rest << ", stress at rest " << f.stress_at_rest
          << ", negative modes seen:" << (f.negative_twist ? " twist" : "")
          << (f.negative_flip ? " flip" : "") << (f.negative_scaling ? " scaling" : "") << "\n";
    return out.str();
  }
};

}  // namespace isostretch::testing
