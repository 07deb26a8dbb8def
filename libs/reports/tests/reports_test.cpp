#include <isostretch/core/error.hpp>
#include <isostretch/deformation/frame_file.hpp>
#include <isostretch/energies/registry.hpp>
#include <isostretch/expressions/expression.hpp>
#include <isostretch/mesh/generators.hpp>
#include <isostretch/reports/energy_report.hpp>
#include <isostretch/reports/interpolation_report.hpp>
#include <isostretch/reports/json_text.hpp>
#include <isostretch/reports/parameterization_report.hpp>
#include <isostretch/reports/sequence_report.hpp>

#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <string>

using namespace isostretch;
using namespace isostretch::reports;

namespace {

const scene::Value& value_of(const scene::Value& object, const std::string& key) {
  const scene::Value* value = object.find(key);
  REQUIRE_MESSAGE(value != nullptr, key);
  return *value;
}

bool holds(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

// A square that is stretched by a handle at its right side, in two frames.
struct Stretched {
  scene::Value scene = scene::parse_json(R"({"schema": 1, "frames": 2})", "test");
  deformation::SolidModel body = deformation::load_solid(
      {.file = {}, .generated = deformation::BarSpec{{4, 2}, {2, 1}, mesh::Shape::triangle}});
  deformation::SequenceOptions options{.energy = energies::make_energy("symmetric_arap")};
  deformation::HandleSet handle_set{script(), body};
  deformation::ElasticProblem problem{options, body, handle_set};
  deformation::Strain strain{body.elements};
  SequenceReport report{{scene, options.script, body, handle_set, problem}};
  Vector positions = body.rest_positions();

  const deformation::HandleScript& script() {
    options.script.frames = 2;
    for (const auto end : {handles::End::min, handles::End::max})
      options.script.handles.push_back(
          {.path = "handles[0]",
           .name = end == handles::End::min ? "left" : "right",
           .select = handles::Slab{0, end, 0.1},
           .keyframes = {{0, {}}, {1, {.translation = {end == handles::End::max ? 0.5 : 0.0, 0, 0}}}},
           .center = {},
           .soft = {}});
    return options.script;
  }

  void make_frame(int frame) {
    deformation::Stepper stepper(options, body, handle_set, problem, [](const std::string&) {});
    const deformation::FrameResult made = stepper.advance(frame, positions);
    report.add_frame(frame, made, strain.at(positions),
                     deformation::handle_misses(handle_set, made.time, body.dim, positions),
                     deformation::frame_name(frame, deformation::FrameFormat::vtu));
  }
};

}  // namespace

TEST_CASE("reports: a parameterization that succeeds, and one with a bound that is missed") {
  const energies::AnyEnergy energy = energies::make_energy("symmetric_dirichlet");
  parameterization::Options options;
  const auto atlas = parameterization::parameterize(mesh::icosphere(3), energy, options);
  const ParameterizationReport report{atlas, options, energy, "folder/sphere.obj"};
  CHECK(status(report) == RunStatus::success);
  CHECK(verdict(report).empty());
  CHECK(layout_warnings(report).empty());
  CHECK(holds(outcome(report), "no triangle is turned over; nothing overlaps"));
  const scene::Value summary =
      scene::parse_json(summary_text(report, {.threads = 3, .total = 1.5}), "summary");
  CHECK(value_of(summary, "threads").number() == 3);
  CHECK(value_of(value_of(summary, "seconds"), "total").number() == 1.5);
  CHECK(value_of(value_of(summary, "mesh"), "file").text() == "folder/sphere.obj");
  CHECK(value_of(summary, "charts").size() == atlas.start.charts.size());
  const std::string page = report_page(report, {}, "model", "layout");
  CHECK(holds(page, "sphere.obj"));
  CHECK(!holds(page, "verdict bad"));

  parameterization::Options bound = options;
  bound.max_distortion = 1.0001;
  const ParameterizationReport missed{atlas, bound, energy, "sphere.obj"};
  CHECK(status(missed) == RunStatus::not_converged);
  CHECK(holds(verdict(missed), "the largest distortion is "));
  CHECK(holds(report_page(missed, {}, "", ""), "verdict bad"));
}

TEST_CASE("reports: a sequence goes on from its state as if it had not been left") {
  Stretched whole, first, second;
  const std::filesystem::path file = std::filesystem::temp_directory_path() / "isostretch_reports_state.json";
  for (Stretched* one : {&whole, &first}) {
    one->report.add_rest(one->strain.at(one->positions), "frame_0000.vtu");
    one->make_frame(1);
  }
  CHECK(whole.report.status() == RunStatus::success);
  whole.make_frame(2);
  first.report.end(SequenceEnd::stop_after, "stopped after frame 1 of 2");
  CHECK(first.report.status() == RunStatus::not_converged);
  CHECK(first.report.verdict() == "stopped after frame 1 of 2; --restart goes on");
  std::ofstream(file) << first.report.state_text(1, first.positions);

  const SequenceState state = second.report.read_state(file);
  std::filesystem::remove(file);
  CHECK(state.frame == 1);
  CHECK(state.warnings.empty());
  CHECK(state.positions == first.positions);
  second.positions = state.positions;
  second.make_frame(2);
  CHECK(second.positions == whole.positions);
  CHECK(second.report.verdict() == "all frames converged, no element is inverted");
  CHECK(second.report.animation_text() == whole.report.animation_text());
  CHECK(holds(whole.report.trace_text(), "frame\n"));
  const scene::Value summary = scene::parse_json(second.report.summary_text({}), "summary");
  CHECK(value_of(summary, "frames").size() == 3);
  CHECK(value_of(summary, "restarted_at").number() == 2);
  CHECK(second.report.figure(second.positions).frame == 2);
  CHECK(holds(second.report.page({}, "png", ""), "Handles, last frame"));
}

TEST_CASE("reports: the state of another scene, a damaged one and none are refused by name") {
  Stretched made;
  made.report.add_rest(made.strain.at(made.positions), "frame_0000.vtu");
  const std::filesystem::path file = std::filesystem::temp_directory_path() / "isostretch_reports_other.json";
  const auto refusal = [&] {
    try {
      Stretched other;
      other.scene["frames"] = 2;
      (void)other.report.read_state(file);
    } catch (const Error& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  CHECK(holds(refusal(), file.string() + ": not there"));
  made.scene["frames"] = 7;
  std::ofstream(file) << made.report.state_text(0, made.positions);
  CHECK(holds(refusal(), "belongs to another scene: 'frames' has changed"));
  made.scene["frames"] = 2;
  std::ofstream(file) << made.report.state_text(0, Vector(made.positions.head(4)));
  CHECK(holds(refusal(), " is damaged: positions: must be "));
  std::filesystem::remove(file);
}

TEST_CASE("reports: an interpolation, and a last step that jumps") {
  deformation::KeyShapes shapes{Stretched().body, Stretched().body};
  deformation::InterpolationOptions options;
  options.frames = 4;
  const energies::AnyEnergy energy = energies::make_energy("symmetric_arap");
  const scene::Value scene = scene::parse_json("{}", "test");
  const deformation::Strain strain(shapes.first.elements);
  const auto report_with = [&](double last_change) {
    InterpolationReport report({scene, options, shapes, energy});
    for (int i = 0; i <= 4; ++i) {
      deformation::InterpolationFrame frame;
      frame.number = i;
      frame.time = 0.25 * i;
      frame.solved = false;
      frame.settled = shapes.first.rest_positions();
      frame.psi = {0.1 * i, 0.4 - 0.1 * i};
      frame.change = i < 4 ? 0.02 : last_change;
      report.add_frame(frame, {strain.at(frame.settled), strain.at(frame.settled)}, "frame.vtu");
      report.add_snapshot({i, frame.time, frame.settled});
    }
    return report;
  };
  const InterpolationReport even = report_with(0.02);
  CHECK(!even.jumps_at_the_end());
  CHECK(report_with(0.5).jumps_at_the_end());
  CHECK(even.status() == RunStatus::success);
  CHECK(even.verdict() == "all frames converged, no element is inverted");
  const figures::InterpolationFigure figure = even.figure();
  CHECK(figure.points.size() == 5);
  CHECK(figure.snapshots.size() == 5);
  CHECK(figure.points[1].psi_1 == doctest::Approx(0.1));
  const scene::Value summary = scene::parse_json(even.summary_text({}), "summary");
  CHECK(value_of(summary, "frames_made").number() == 4);
  CHECK(value_of(summary, "min_det_F").number() == doctest::Approx(1));
  CHECK(holds(even.page({}, "a", "b", ""), "From the first pose to the second"));

  InterpolationReport stopped = report_with(0.02);
  stopped.end(InterpolationEnd::failed, "frame 3: no progress");
  CHECK(stopped.status() == RunStatus::failed);
  CHECK(stopped.verdict() == "frame 3: no progress");
}

TEST_CASE("reports: an energy as text, summary and page") {
  const std::string text = "mu/2*(I2-d) - mu*log(J)";
  const auto findings = inspection::inspect(expressions::parse_energy(text, {{"mu", 1}}), text, {0.5, 2}, 2);
  CHECK(holds(report_text(findings), "At rest, in 2D"));
  const scene::Value summary = scene::parse_json(summary_text(findings), "summary");
  CHECK(value_of(summary, "is_expression").truth());
  CHECK(value_of(summary, "studies").size() == 1);
  CHECK(holds(report_page(findings, {"png"}), "Derivatives, in 2D"));
}

TEST_CASE("reports: misses of handles as JSON and as a table") {
  const deformation::HandleMiss miss{.name = "tip",
                                     .soft = true,
                                     .nodes = 1,
                                     .size = 0,
                                     .size_reached = 0,
                                     .mean = 0.25,
                                     .largest = 0.5,
                                     .farthest_node = 7};
  const std::string json = misses_json({miss});
  const scene::Value parsed = scene::parse_json(json, "misses");
  REQUIRE(parsed.size() == 1);
  CHECK(value_of(parsed.items()[0], "share_of_size").is_null());
  CHECK(value_of(parsed.items()[0], "farthest_node").number() == 7);
  const std::string table = handle_table(
      R"([{"name": "tip", "nodes": 1, "kind": "soft", "weight": 2}, {"name": "end", "nodes": 3, "kind": "hard"}])",
      json);
  CHECK(holds(table, "0.25"));
  CHECK(holds(table, "–"));
}
