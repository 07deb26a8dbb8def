#include <isostretch/core/error.hpp>
#include <isostretch/deformation/interpolation.hpp>
#include <isostretch/deformation/manipulation.hpp>
#include <isostretch/deformation/sequence.hpp>
#include <isostretch/deformation/strain.hpp>
#include <isostretch/energies/registry.hpp>

#include <doctest/doctest.h>

#include <limits>
#include <string>
#include <utility>
#include <vector>

using namespace isostretch;
using namespace isostretch::deformation;

namespace {

SolidModel bar(mesh::Shape shape = mesh::Shape::tet) {
  return load_solid({.file = {}, .generated = BarSpec{{6, 2, 2}, {3, 1, 1}, shape}});
}

// Both ends held; the right one turns about the bar.
HandleScript twist(double degrees, int frames) {
  const handles::Keyframe rest{0, {}}, end{1, {.axis = handles::Point::UnitX(), .degrees = degrees}};
  HandleScript script;
  script.handles = {{.path = "handles[0]",
                     .name = "left",
                     .select = handles::Slab{0, handles::End::min, 0.1},
                     .keyframes = {rest},
                     .center = {},
                     .soft = {}},
                    {.path = "handles[1]",
                     .name = "right",
                     .select = handles::Slab{0, handles::End::max, 0.1},
                     .keyframes = {rest, end},
                     .center = {},
                     .soft = {}}};
  script.frames = frames;
  return script;
}

SequenceOptions options_for(const HandleScript& script) {
  SequenceOptions options{.energy = energies::make_energy("symmetric_arap")};
  options.script = script;
  return options;
}

}  // namespace

TEST_CASE("Sequence: every frame converges with its handles in place, and none inverts an element") {
  for (const mesh::Shape shape : {mesh::Shape::tet, mesh::Shape::hex}) {
    const SolidModel body = bar(shape);
    Sequence sequence(options_for(twist(120, 3)), body);
    const Strain strain(body.elements);
    CHECK(sequence.positions() == body.rest_positions());
    for (int frame = 1; frame <= 3; ++frame) {
      REQUIRE_FALSE(sequence.done());
      const FrameResult made = sequence.next();
      CHECK(made.reached);
      CHECK(made.summary.converged());
      CHECK(sequence.frame() == frame);
      CHECK(strain.at(sequence.positions()).inverted.empty());
      const HandleSet handle_set(twist(120, 3), body);
      Vector placed = sequence.positions();
      handle_set.place_hard(made.time, placed);
      CHECK(placed == sequence.positions());
    }
    CHECK(sequence.done());
    CHECK_THROWS_WITH_AS(sequence.next(), doctest::Contains("no frame left"), Error);
  }
}

TEST_CASE("Sequence: a request to stop ends a frame, which is not reached then") {
  const StopSource source;
  int shown = 0;
  const Monitor monitor{source.token(), [&](const std::string& line) {
                          CHECK(line.find("frame 1 of 2") == 0);
                          if (++shown == 2) source.request_stop();
                        }};
  Sequence sequence(options_for(twist(150, 2)), bar(), monitor);
  const FrameResult made = sequence.next();
  CHECK(made.summary.outcome() == SolveStatus::interrupted);
  CHECK_FALSE(made.reached);
  CHECK(sequence.done());
}

TEST_CASE("Sequence: a handle without a vertex is refused by its path") {
  HandleScript script = twist(10, 1);
  script.handles[1].select = handles::Sphere{{100, 100, 100}, 1};
  CHECK_THROWS_WITH_AS(Sequence(options_for(script), bar()), doctest::Contains("handles[1]"), Error);
}

TEST_CASE("Sequences without frames, and shapes that do not belong together, are refused") {
  HandleScript script = twist(10, 1);
  script.frames = 0;
  CHECK_THROWS_WITH_AS(Sequence(options_for(script), bar()), "frames: must be 1 at least", OptionError);
  const energies::AnyEnergy energy = energies::make_energy("symmetric_arap");
  const KeyShapes same{bar(), bar()};
  InterpolationOptions options;
  options.frames = 0;
  CHECK_THROWS_WITH_AS(Interpolation(options, same, energy), "frames: must be 1 at least", OptionError);
  options.frames = 2;
  const KeyShapes other{bar(), bar(mesh::Shape::hex)};
  CHECK_THROWS_WITH_AS(Interpolation(options, other, energy), doctest::Contains("the second shape has hexes"),
                       Error);
  CHECK_THROWS_WITH_AS(Interpolation(options, same, energies::make_energy("dirichlet")),
                       doctest::Contains("not at its minimum at rest"), Error);
}

TEST_CASE("Interpolation: begins and ends with the key shapes to the bit, without an inversion between") {
  const SolidModel first = bar();
  Sequence sequence(options_for(twist(90, 2)), first);
  while (!sequence.done()) sequence.next();
  SolidModel second = first;
  second.nodes = first.points(sequence.positions());
  mesh::ElementMesh m;
  m.shape = mesh::Shape::tet;
  m.vertices = second.nodes;
  m.elements = Eigen::Map<const mesh::Tets>(first.elements.nodes.data(), first.elements.element_count(), 4);
  const KeyShapes shapes{first, solid_from(std::move(m), {})};
  InterpolationOptions options;
  options.frames = 4;
  Interpolation interpolation(options, shapes, energies::make_energy("symmetric_arap"));
  std::vector<InterpolationFrame> frames;
  while (!interpolation.done()) frames.push_back(interpolation.next());
  REQUIRE(frames.size() == 5);
  CHECK(interpolation.placed(frames.front()) == first.rest_positions());
  CHECK(interpolation.placed(frames.back()) == shapes.second.rest_positions());
  const Strain strain(first.elements);
  for (const InterpolationFrame& frame : frames) {
    CHECK(frame.complete());
    CHECK(strain.at(interpolation.placed(frame)).inverted.empty());
  }
}

TEST_CASE("Manipulation: a twist is solved to its gap, and its trace is a table") {
  const SolidModel body = bar();
  ManipulationOptions options;
  options.script = twist(60, 2);
  const HandleSet handle_set(options.script, body);
  const ElementRotations rotations(options, body, handle_set);
  Manipulation manipulation(options, body, handle_set, rotations);
  const ManipulationFrame frame = manipulation.solve(2);
  REQUIRE(frame.made());
  CHECK(frame.summary.outcome() == SolveStatus::converged);
  CHECK(frame.summary.inverted == 0);
  CHECK(frame.time == 1);
  const Trace trace = sdp_penalty::trace_table(frame.summary);
  CHECK(trace.rows.size() == frame.summary.trace.size());
  CHECK(trace.rows.back()[trace.column("gap")] <= options.solver.gap_tolerance);
}
