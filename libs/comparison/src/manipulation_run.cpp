#include <isostretch/comparison/manipulation_pictures.hpp>
#include <isostretch/comparison/manipulation_run.hpp>
#include <isostretch/core/error.hpp>
#include <isostretch/core/log.hpp>
#include <isostretch/core/text.hpp>
#include <isostretch/figures/solid_figure.hpp>

#include <utility>
#include <vector>

namespace isostretch::comparison {
namespace {

std::string stop_reason(const StopToken& stop, double time_limit) {
  if (stop.stop_requested()) return "interrupted (Ctrl-C)";
  if (stop.deadline_passed()) return formatted("stopped after %g seconds (--time-limit)", time_limit);
  return {};
}

}  // namespace

ManipulationRun::ManipulationRun(const scene::ManipulationScene& scene, const deformation::SolidModel& body,
                                 const deformation::HandleSet& handle_set, ManipulationRunOptions options,
                                 ManipulationSeconds seconds, const Timer& timer)
    : scene_(scene),
      body_(body),
      options_(std::move(options)),
      seconds_(seconds),
      timer_(timer),
      rotations_(scene, body, handle_set, options_.weights_cache),
      report_{scene, body, handle_set, rotations_, options_.name},
      strain_(body.elements),
      animation_(body, figures::figure_lines(handle_set, body), scene.up) {
  seconds_.weights = rotations_.seconds();
  report_.wanted = options_.last - options_.first + 1;
}

void ManipulationRun::warn(const std::string& text) {
  report_.warnings.push_back(text);
  log(LogLevel::warning, text);
}

void ManipulationRun::run(OutputFolder& folder, const Monitor& monitor) {
  const std::string loose =
      deformation::loose_components_text(deformation::loose_components(report_.handle_set, body_));
  if (!loose.empty()) warn(loose);
  {
    const ScopedTimer timer(seconds_.write);
    write_rest(folder);
  }
  make_frames(folder, monitor);
  write_reports(folder);
}

void ManipulationRun::write_frame(OutputFolder& folder, const std::string& file, const Vector& positions,
                                  const StrainedShape& shape) const {
  folder.write_now(file, deformation::format_frame(scene_.format, body_, positions,
                                                   {{"min_eig_S", shape.eigenvalues},
                                                    {"det_F", shape.strain.min_det},
                                                    {"length_change", shape.strain.length_change}}));
}

void ManipulationRun::write_rest(OutputFolder& folder) {
  const std::string file = deformation::frame_name(0, scene_.format);
  const Vector rest = body_.rest_positions();
  StrainedShape shape{strain_.at(rest), {}};
  shape.eigenvalues.assign(shape.strain.min_det.size(), 1.0);
  write_frame(folder, file, rest, shape);
  report_.add_rest(shape.strain, file);
  if (options_.first == 1) animation_.add(0, scene_.script.start, rest, shape.strain);
  if (rotations_.weights())
    folder.write_now("weights.vtu",
                     deformation::format_rest(body_, deformation::weight_fields(*rotations_.weights())));
}

void ManipulationRun::make_frames(OutputFolder& folder, const Monitor& given) {
  const Monitor monitor = given.with_time_limit(options_.time_limit);
  const auto halt = [&] { return stop_reason(monitor.stop, options_.time_limit); };
  FrameSolver solver(scene_, body_, report_.handle_set, rotations_, monitor,
                     {scene_.rival, options_.memory_limit, halt});
  for (int frame = options_.first; frame <= options_.last && !report_.stopped; ++frame) {
    if (const std::string reason = halt(); !reason.empty() && frame > options_.first) {
      report_.stopped = true;
      report_.message = reason + formatted(" before frame %d", frame);
      return;
    }
    ManipulationFrame made;
    {
      const ScopedTimer timer(seconds_.solve);
      made = solver.solve(frame);
    }
    if (made.stopped()) {
      report_.stopped = true;
      report_.message = formatted("frame %d: ", frame) + made.summary.message;
    }
    const ScopedTimer timer(seconds_.write);
    take(std::move(made), folder);
  }
}

void ManipulationRun::take(ManipulationFrame made, OutputFolder& folder) {
  const std::string file = deformation::frame_name(made.frame, scene_.format);
  if (!made.made()) {
    report_.add(made, {}, {}, file);
    log(LogLevel::warning, formatted("frame %d: ", made.frame) + made.trouble);
    return;
  }
  const StrainedShape before = report_.shape(strain_, made.given, made.before),
                      after = report_.shape(strain_, made.rotations, made.positions);
  write_frame(folder, file, made.positions, after);
  report_.add(made, before, after, file);
  animation_.add(made.frame, made.time, made.positions, after.strain);
  log(LogLevel::info, report_.frame_text(made, before, after));
  if (photo_) photo_->add(made.frame, body_.points(made.positions).leftCols<2>());
  report_.last = std::move(made);
}

void ManipulationRun::write_photos(OutputFolder& folder) {
  if (!photo_) return;
  const int shrink = photo_->draw(
      [&](int frame, const std::string& png) { folder.add(formatted("photo_%04d.png", frame), png); });
  if (shrink > 1)
    warn(formatted("the photo is drawn %d times smaller: at its own scale it would be too large", shrink));
}

void ManipulationRun::write_pictures(OutputFolder& folder) {
  if (!options_.picture || report_.last.positions.size() == 0) return;
  folder.add("manipulate.png", states_ = draw_states(report_, strain_));
  folder.add("path.png", path_ = draw_path(report_, strain_));
}

void ManipulationRun::write_reports(OutputFolder& folder) {
  for (const std::string& text : report_.last_warnings(strain_)) warn(text);
  {
    const ScopedTimer timer(seconds_.write);
    write_photos(folder);
    folder.add("trace.csv", to_csv(report_.trace));
    if (scene_.format == deformation::FrameFormat::vtu)
      folder.add("manipulate.pvd", deformation::pvd_text(report_.files()));
    if (options_.glb)
      if (const std::string told = figures::add_glb(folder, animation_, "manipulate"); !told.empty())
        warn(told);
    write_pictures(folder);
  }
  seconds_.total = timer_.seconds();
  folder.add("summary.json", summary_text(report_, seconds_, options_.threads));
  if (options_.picture)
    folder.add("report.html", report_page(report_, seconds_, states_, path_, animation_.preview()));
}

std::optional<figures::PhotoFrames> read_photo(const scene::ManipulationScene& scene,
                                               const deformation::SolidModel& body,
                                               const std::filesystem::path& folder) {
  const auto spec = scene::read_photo_spec(scene.value, folder);
  if (!spec) return {};
  const figures::Photo photo =
      with_error_kind(ErrorKind::input, [&] { return figures::read_photo(spec->file); });
  const mesh::Points2 rest = body.nodes.leftCols<2>();
  const figures::PhotoPlacement placement =
      spec->fit == scene::PhotoFit::pixels ? figures::unit_pixels(photo) : figures::filling_box(photo, rest);
  return figures::PhotoFrames(photo, placement, body.surface.mesh.triangles, rest);
}

}  // namespace isostretch::comparison
