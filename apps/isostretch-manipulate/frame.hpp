#pragma once

#include "path.hpp"
#include "rotations.hpp"

#include <isostretch/core/timer.hpp>
#include <isostretch/sdp_penalty/relinearize.hpp>

#include <string>
#include <vector>

namespace isostretch::app::manipulate {

// What became of one frame.
struct FrameResult {
  int frame = 0;
  double time = 0;
  sdp_penalty::Summary summary;
  std::string trouble = {};            // why there are no positions; empty where there are
  std::vector<double> given = {};      // ex-rotations of the elements
  std::vector<double> rotations = {};  // those of the last round where it was re-linearised, else the same
  Vector positions = {};
  Vector before = {};  // ex-rotated skinning
  Path path = {};
  std::vector<sdp_penalty::RelinearizeRound> rounds = {};  // where they were asked for
  double seconds = 0;

  bool made() const { return trouble.empty(); }
};

// Solves frames, each for itself.
class FrameSolver {
 public:
  FrameSolver(const Scene& scene, const Body& body, const Rig& rig, const ElementRotations& rotations,
              double time_limit);

  // Ctrl-C and the time limit end it after an iteration.
  FrameResult solve(int frame);

  // The reason to begin no other frame, if there is one.
  std::string halt() const;

 private:
  void find_loose_nodes();
  void place_targets(double time);
  void run(FrameResult& result);
  void relinearize(FrameResult& result);
  void put_loose_nodes_back(Vector& positions) const;

  const Scene& scene_;
  const Body& body_;
  const Rig& rig_;
  const ElementRotations& rotations_;
  double time_limit_;
  Timer timer_;
  Vector rest_;
  std::vector<int> loose_nodes_;  // of components without a handle, and of no element
  std::vector<int> loose_holds_;  // one a component, and those of no element
  sdp_penalty::Problem problem_;
  sdp_penalty::Solver solver_;
};

}  // namespace isostretch::app::manipulate
