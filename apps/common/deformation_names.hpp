#pragma once

#include <isostretch/deformation/frame_file.hpp>
#include <isostretch/deformation/handle_misses.hpp>
#include <isostretch/deformation/handle_set.hpp>
#include <isostretch/deformation/material.hpp>
#include <isostretch/deformation/predictor.hpp>
#include <isostretch/deformation/solid_check.hpp>
#include <isostretch/deformation/solid_model.hpp>
#include <isostretch/deformation/strain.hpp>

namespace isostretch::app {

// What the apps about bodies speak of all the time.
using deformation::BallSpec;
using deformation::BarSpec;
using deformation::DiscSpec;
using deformation::format_frame;
using deformation::frame_name;
using deformation::FrameFormat;
using deformation::GeneratedSolid;
using deformation::GridSpec;
using deformation::Handle;
using deformation::HandleMiss;
using deformation::HandleScript;
using deformation::HandleSet;
using deformation::HandleSpec;
using deformation::InitialGuess;
using deformation::Lame;
using deformation::MeshRepair;
using deformation::Plane;
using deformation::pvd_text;
using deformation::QuadrupedSpec;
using deformation::require_holds;
using deformation::SolidCheck;
using deformation::SolidModel;
using deformation::SolidSpec;
using deformation::Strain;
using deformation::StrainField;

}  // namespace isostretch::app
