#pragma once

#include "common/output_folder.hpp"

#include <isostretch/baselines/distortion.hpp>
#include <isostretch/scene/node.hpp>

#include <nlohmann/json.hpp>

#include <filesystem>
#include <string>

namespace isostretch::app::compare {

// What every method is given: elements whose rest has area or volume 1, what stays in its place, and where
// all of them start.
struct Problem {
  std::string name;
  baselines::DistortionProblem distortion;
  Vector start;
  Json facts;  // mesh, elements, nodes, energy, fingerprint, ..., for reports

  int flips(const Vector& x) const;  // elements with det F <= 0 at some quadrature point
};

// A problem of a scene, whose files are sought from `folder`: with handles a body, whose hard handles are
// where they come to in the end; without any a surface to flatten. Throws Error naming the key by its path,
// and Failure with ExitCode::input naming the mesh, or the problem and the element where its energy is not
// finite at the start.
Problem read_problem(const scene::Node& value, const std::filesystem::path& folder);

}  // namespace isostretch::app::compare
