#pragma once

#include "common/deformation_names.hpp"

#include <isostretch/deformation/sequence_options.hpp>
#include <isostretch/scene/value.hpp>

namespace isostretch::app::deform {

// All that results depend on, besides the body.
struct Scene : deformation::SequenceOptions {
  scene::Value value;  // as it was read, with what the command line adds
  FrameFormat format = FrameFormat::vtu;
};

}  // namespace isostretch::app::deform
