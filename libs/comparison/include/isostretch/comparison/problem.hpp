#pragma once

#include <isostretch/baselines/distortion.hpp>
#include <isostretch/comparison/record.hpp>
#include <isostretch/scene/node.hpp>

#include <filesystem>
#include <functional>
#include <string>

namespace isostretch::comparison {

/// A problem as every method is given it: elements whose rest has area or volume 1, what stays in its place,
/// and where all of them start.
struct Problem {
  std::string name;                         ///< Name, which can name a folder.
  baselines::DistortionProblem distortion;  ///< Elements, energy and what is held.
  Vector start;                             ///< Positions, dim entries a node.
  Record facts;                             ///< mesh, elements, nodes, energy, fingerprint, ..., for reports

  /// Returns the number of elements with det F <= 0 at some quadrature point.
  int flips(const Vector& x) const;
};

/// Is told what a user should know of a problem that can be compared all the same.
using ProblemWarning = std::function<void(const std::string&)>;

/// Returns a problem of a scene, whose files are sought from `folder`: with handles a body, whose hard
/// handles are where they come to in the end; without any a surface to flatten. Throws Error naming the key
/// by its path, and of kind input naming the mesh, or the problem and the element where its energy is not
/// finite at the start.
Problem read_problem(const scene::Node& value, const std::filesystem::path& folder,
                     const ProblemWarning& warn);

}  // namespace isostretch::comparison
