#pragma once

#include "study.hpp"

#include <string>
#include <utility>
#include <vector>

namespace isostretch::app::inspect {

// An energy with what was found out about it, in the dimensions asked for.
struct Findings {
  const Options& options;
  const energies::AnyEnergy& energy;
  std::vector<Study> studies;
};

// What terminal and page have in common: names with what is to say of them, and rows of tables.
using Facts = std::vector<std::pair<std::string, std::string>>;
using Rows = std::vector<std::vector<std::string>>;

std::string dimension_name(const Study& study);  // "in 3D"
std::string stretches_text(const Spectrum& spectrum);

Facts energy_facts(const Findings& findings);
Facts rest_facts(const Study& study);
Facts convexity_facts(const Study& study, const Range& range);

inline constexpr const char* mode_columns[] = {"modes", "negative in the sample", "least", "at"};
Rows mode_rows(const Study& study);
std::string sample_text(const Study& study);

inline constexpr const char* example_columns[] = {"kind",  "stretches", "psi",    "stress",
                                                  "twist", "flip",      "scaling"};
Rows example_rows(const Study& study);

// Those that are not zero; the names of the others.
Facts formula_facts(const Study& study);
std::string zero_formulas(const Study& study);

// All of it in a line.
std::string verdict(const Findings& findings);

}  // namespace isostretch::app::inspect
