#pragma once

#include <isostretch/inspection/study.hpp>

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace isostretch::inspection {

/// An energy with what was found out about it.
struct Findings {
  energies::AnyEnergy energy;  ///< Energy.
  std::string source;          ///< Its name or expression.
  StretchRange range;          ///< Stretches that were looked at.
  std::vector<Study> studies;  ///< A study for each dimension that was asked for and that there is.
};

/// Studies an energy in the dimension asked for, or in both where there are both. `source` is its name or
/// expression.
Findings inspect(const energies::AnyEnergy& energy, const std::string& source, const StretchRange& range,
                 std::optional<int> dim = {});

/// Names with what is to say of them.
using Facts = std::vector<std::pair<std::string, std::string>>;
/// Rows of a table.
using Rows = std::vector<std::vector<std::string>>;

/// Returns the dimension in words, "in 3D".
std::string dimension_name(const Study& study);
/// Returns the stretches in parentheses, four digits each.
std::string stretches_text(const Spectrum& spectrum);

/// Returns the name, the parameters and the domain of the energy.
Facts energy_facts(const Findings& findings);
/// Returns stress, moduli and eigenvalues at rest, and whether it is a minimum.
Facts rest_facts(const Study& study);
/// Returns where the Hessian is positive semi-definite.
Facts convexity_facts(const Study& study, const StretchRange& range);

/// Names of the columns of mode_rows().
inline constexpr const char* mode_columns[] = {"modes", "negative in the sample", "least", "at"};
/// Returns a row for each mode: where it is negative, and its least eigenvalue.
Rows mode_rows(const Study& study);
/// Returns how many samples there are in and outside of the domain.
std::string sample_text(const Study& study);

/// Names of the columns of example_rows().
inline constexpr const char* example_columns[] = {"kind",  "stretches", "psi",    "stress",
                                                  "twist", "flip",      "scaling"};
/// Returns a row for each example.
Rows example_rows(const Study& study);

/// Returns the derivatives that are not zero.
Facts formula_facts(const Study& study);
/// Returns the names of the derivatives that are zero, with commas between.
std::string zero_formulas(const Study& study);

/// Returns all of it in a line.
std::string verdict(const Findings& findings);

}  // namespace isostretch::inspection
