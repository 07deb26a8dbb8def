#pragma once

#include "common/frames.hpp"
#include "common/guess.hpp"
#include "common/handle_script.hpp"
#include "common/output_folder.hpp"

#include <isostretch/energies/any_energy.hpp>
#include <isostretch/newton/options.hpp>

#include <nlohmann/json.hpp>

#include <optional>
#include <string>
#include <vector>

namespace isostretch::app::deform {

struct RegionSpec {
  std::string path;  // in the scene, for messages
  std::string name;
  std::optional<handles::Selection> select;  // elements all of whose nodes are in it
  std::vector<int> elements;                 // otherwise
  energies::AnyEnergy energy;
};

// All that results depend on, besides the body.
struct Scene {
  Json json;  // as it was read, with what the command line adds
  energies::AnyEnergy energy;
  std::vector<RegionSpec> regions = {};
  HandleScript script = {};
  Guess guess = Guess::biharmonic;
  FrameFormat format = FrameFormat::vtu;
  newton::Options newton = {};
};

}  // namespace isostretch::app::deform
