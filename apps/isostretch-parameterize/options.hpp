#pragma once

#include <isostretch/energies/any_energy.hpp>
#include <isostretch/parameterization/options.hpp>

#include <filesystem>
#include <optional>

namespace isostretch::app::parameterize {

using parameterization::AlignedVertices;
using parameterization::Boundary;
using parameterization::Initial;
using parameterization::OverlapRule;
using parameterization::Pack;
using parameterization::Pin;
using parameterization::Point2;
using parameterization::SoftPin;
using parameterization::UvUnits;

/// The command line.
struct Options : parameterization::Options {
  energies::AnyEnergy energy;
  std::filesystem::path model = {};
  std::filesystem::path out = {};
  bool check = false;  // only say what is wrong with the model
  bool repair = false;
  std::optional<double> weld = {};  // tolerance
  bool picture = true;
  bool glb = false;
};

}  // namespace isostretch::app::parameterize
