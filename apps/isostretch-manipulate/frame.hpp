#pragma once

#include "options.hpp"
#include "path.hpp"
#include "rotations.hpp"

#include <isostretch/baselines/solver.hpp>
#include <isostretch/core/timer.hpp>
#include <isostretch/sdp_penalty/relinearize.hpp>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace isostretch::app::manipulate {

// What became of one frame.
struct FrameResult {
  int frame = 0;
  double time = 0;
  sdp_penalty::Summary summary;  // of a rival what it has of it, without a status
  std::optional<baselines::Result> rival = {};
  std::string trouble = {};            // why there are no positions; empty where there are
  std::vector<double> given = {};      // ex-rotations of the elements
  std::vector<double> rotations = {};  // those of the last round where it was re-linearised, else the same
  Vector positions = {};
  Vector before = {};  // ex-rotated skinning
  Path path = {};
  std::vector<sdp_penalty::RelinearizeRound> rounds = {};  // where they were asked for
  double seconds = 0;

  bool made() const { return trouble.empty(); }
  bool certified() const { return !rival && summary.status == sdp_penalty::Status::optimal; }
  // As it should end: certified, or by a rival's own account at its goal.
  bool reached() const { return rival ? rival->status == baselines::Status::converged : certified(); }
  bool stopped() const {
    return rival ? rival->status == baselines::Status::callback
                 : summary.status == sdp_penalty::Status::callback;
  }
  std::string_view status() const {
    return rival ? baselines::status_name(rival->status) : sdp_penalty::status_name(summary.status);
  }
};

// Solves frames, each for itself.
class FrameSolver {
 public:
  FrameSolver(const Scene& scene, const Body& body, const Rig& rig, const ElementRotations& rotations,
              const Options& options);

  // Ctrl-C and the time limit end it after an iteration.
  FrameResult solve(int frame);

  // The reason to begin no other frame, if there is one.
  std::string halt() const;

 private:
  void find_loose_nodes();
  void place_targets(double time);
  void run(FrameResult& result);
  void run_rival(FrameResult& result);
  Vector skinned() const;
  void relinearize(FrameResult& result);
  void put_loose_nodes_back(Vector& positions) const;

  const Scene& scene_;
  const Body& body_;
  const Rig& rig_;
  const ElementRotations& rotations_;
  const Options& options_;
  Timer timer_;
  Vector rest_;
  std::vector<int> loose_nodes_;  // of components without a handle, and of no element
  std::vector<int> loose_holds_;  // one a component, and those of no element
  sdp_penalty::Problem problem_;
  sdp_penalty::Solver solver_;
};

}  // namespace isostretch::app::manipulate
