#pragma once

#include <isostretch/core/monitor.hpp>
#include <isostretch/deformation/elastic_problem.hpp>
#include <isostretch/deformation/predictor.hpp>
#include <isostretch/newton/solver.hpp>

#include <memory>
#include <string>
#include <vector>

namespace isostretch::deformation {

/// The outcome of one frame.
struct FrameResult {
  newton::Summary summary;  ///< All parts of the step together: sums, and the status of the last.
  int parts = 0;            ///< Solves; more than one where the handles had to be moved in parts.
  double seconds = 0;       ///< Seconds of the frame.
  bool reached = false;     ///< Whether the handles are where they belong at the frame's time.
  double time = 0;          ///< Time at which the positions are.
  std::string why;          ///< Reason why the frame was not reached.
};

/// A maker of frames from parts that the caller keeps: to go on from a frame that was made before, or to look
/// at the energy between frames. Sequence is easier.
class Stepper {
 public:
  /// Prepares steps. All arguments that are references must outlive this object.
  Stepper(const SequenceOptions& options, const SolidModel& body, const HandleSet& handle_set,
          ElasticProblem& problem, Warn warn, const Monitor& monitor = {});

  /// Moves `positions`, which belong to the frame before, to this frame. Where the initial guess is outside
  /// the domain of the energy, the handles go half the way first, and so on; where even 1/4096 of the way is,
  /// the frame is not reached and the reason names the element. A request to stop and the limit of time end
  /// it after an iteration.
  FrameResult advance(int frame, Vector& positions);

 private:
  bool solve_part(int frame, double time, Vector& positions, FrameResult& result);
  double time_within(int frame, double way) const;
  std::string obstacle(int frame, const Vector& guess) const;
  std::string overflow(const StrainField& strain) const;

  const SequenceOptions& options_;
  const SolidModel& body_;
  const HandleSet& handle_set_;
  ElasticProblem& problem_;
  Monitor monitor_;
  newton::Solver solver_;
  Predictor predictor_;
  Strain strain_;
};

/// A body that is deformed frame by frame, from its rest shape: the minimiser of its energy for where the
/// handles are, each frame started from the one before, with one symbolic analysis for all.
class Sequence {
 public:
  /// Prepares the frames. Throws Error naming the handle or region at fault.
  Sequence(SequenceOptions options, SolidModel body, const Monitor& monitor = {});
  ~Sequence();
  /// Takes over the other sequence, which is left to be destroyed or assigned to.
  Sequence(Sequence&&) noexcept;
  /// Takes over the other sequence, which is left to be destroyed or assigned to.
  Sequence& operator=(Sequence&&) noexcept;

  /// Makes the next frame, as Stepper::advance() does. Throws Error once done().
  FrameResult next();
  /// Returns whether the last frame is made, or one was not reached.
  bool done() const;
  /// Returns the number of the frame that was made last; 0 is the rest shape.
  int frame() const;
  /// Returns the positions of the frame that was made last, dim entries per node.
  const Vector& positions() const;
  /// Returns the body at rest.
  const SolidModel& body() const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace isostretch::deformation
