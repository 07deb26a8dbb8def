#pragma once

// What check_energy() found, as data and as text.

#include <algorithm>
#include <sstream>
#include <string>
#include <vector>

namespace isostretch::testing {

/// One property of an energy in one dimension, with the worst case over all deformation samples.
struct EnergyCheck {
  int dim;
  std::string what;
  double tolerance;
  double worst = 0;
  std::string where;  ///< category and F of the worst case
  int samples = 0;

  /// Not (worst > tolerance): NaN is a failure.
  bool ok() const { return worst <= tolerance; }
};

/// Facts rather than verdicts: an energy may well have stress at rest, or be convex.
struct EnergyFacts {
  int dim;
  double psi_at_rest = 0;
  double stress_at_rest = 0;  ///< |d psi / d sigma| at sigma = 1
  /// Which modes were seen negative among the samples with det F > 0.
  bool negative_twist = false, negative_flip = false, negative_scaling = false;
};

struct EnergyReport {
  std::string name;
  std::vector<EnergyCheck> checks;
  std::vector<EnergyFacts> facts;

  bool ok() const {
    return !checks.empty() &&
           std::all_of(checks.begin(), checks.end(), [](const EnergyCheck& c) { return c.ok(); });
  }

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
