#pragma once

#include "common/choice_names.hpp"
#include "common/frames.hpp"

#include <isostretch/newton/options.hpp>

#include <filesystem>
#include <map>
#include <string>

namespace isostretch::app::interpolate {

// Where the minimisation of a frame starts from.
enum class Guess {
  previous,     // the frame before
  extrapolate,  // that, or of several continuations of the frames so far the one of least energy
};
inline constexpr ChoiceNames<Guess, 2> guess_names{
    {{"previous", Guess::previous}, {"extrapolate", Guess::extrapolate}}};

// Frames end as soon as a full step gains less than a millionth of the energy: what is left then is far below
// what can be seen, and to prove more takes a factorization that moves nothing. One or two factorizations a
// frame do not repay the time for nested dissection; and since starts are good nearly everywhere, the Hessian
// is filtered only where they are not, which takes fewer of them than other projections (docs/apps).
inline newton::Options frame_solver() {
  newton::Options options;
  options.relative_energy_tolerance = 1e-6;
  options.projection = newton::Projection::progressive;
  options.solver.ordering = sparse::Ordering::amd;
  return options;
}

struct Options {
  std::filesystem::path first, second;  // meshes
  std::filesystem::path out;
  MeshRepair repair;
  int frames = 10;  // after the first pose; the last is the second pose
  std::string energy = "symmetric_arap";
  std::map<std::string, double> parameters = {};
  Guess guess = Guess::extrapolate;
  FrameFormat format = FrameFormat::vtu;
  bool pictures = true;
  bool glb = false;
  bool check = false;                       // look at the poses, and make nothing
  newton::Options newton = frame_solver();  // its time limit is that of all frames together

  // The last frame is exactly at 1.
  double time(int frame) const { return static_cast<double>(frame) / frames; }
};

}  // namespace isostretch::app::interpolate
