#pragma once

#include <isostretch/deformation/interpolation_options.hpp>
#include <isostretch/deformation/manipulation_options.hpp>
#include <isostretch/deformation/sequence_options.hpp>
#include <isostretch/parameterization/options.hpp>
#include <isostretch/scene/node.hpp>

namespace isostretch::scene {

/// Reads "newton" of a scene into options that hold the defaults. A gradient tolerance that is given is the
/// only test of convergence, unless the scene gives others beside it. Throws Error naming the key by its
/// path.
void read_newton(const Node& scene, newton::Options& options);

/// Reads how a body of that dimension is deformed: "energy", "material", "regions", "handles", "frames",
/// "initial_guess" and "newton". Throws Error naming the key by its path.
deformation::SequenceOptions read_sequence(const Node& scene, int dim);

/// Reads how a body of that dimension is manipulated: "handles", "frames" and "manipulation". Throws Error
/// naming the key by its path.
deformation::ManipulationOptions read_manipulation(const Node& scene, int dim);

/// Reads how shapes between two are made: "frames", "interpolation" and "newton". Throws Error naming the key
/// by its path.
deformation::InterpolationOptions read_interpolation(const Node& scene);

/// Reads how a surface is flattened: "parameterization" and "newton". Throws Error naming the key by its
/// path, and OptionError for options that do not go together.
parameterization::Options read_parameterization(const Node& scene);

/// Returns the fields of the options that stand in "interpolation" of a scene.
std::vector<OptionField> interpolation_fields(deformation::InterpolationOptions& options);
/// Returns the fields of the options that stand in "parameterization" of a scene, beside pins and lines.
std::vector<OptionField> parameterization_fields(parameterization::Options& options);

}  // namespace isostretch::scene
