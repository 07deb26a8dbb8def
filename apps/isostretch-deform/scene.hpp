#pragma once

#include "common/frames.hpp"
#include "common/output_folder.hpp"

#include <isostretch/deformation/handle_script.hpp>
#include <isostretch/deformation/sequence_options.hpp>

#include <nlohmann/json.hpp>

#include <optional>
#include <string>
#include <vector>

namespace isostretch::app::deform {

// All that results depend on, besides the body.
struct Scene : deformation::SequenceOptions {
  Json json;  // as it was read, with what the command line adds
  FrameFormat format = FrameFormat::vtu;
};

}  // namespace isostretch::app::deform
