#include <isostretch/core/timer.hpp>
#include <isostretch/parameterization/parameterize.hpp>

#include <utility>

namespace isostretch::parameterization {
namespace {

template <class Work>
auto timed(PhaseTimes& times, const char* phase, const Work& work) {
  const Timer timer;
  auto result = work();
  times.add(phase, timer.seconds());
  return result;
}

}  // namespace

bool Parameterization::succeeded(const Options& options) const {
  const bool within = options.max_distortion == 0 || solution.worst_distortion <= options.max_distortion;
  return solution.summary.converged() && layout.flipped.empty() && within;
}

mesh::SurfaceMesh Parameterization::textured() const {
  mesh::SurfaceMesh result = domain.input;
  result.uv = layout.uv;
  result.uv_triangles = domain.open().triangles;
  return result;
}

Parameterization parameterize(const mesh::SurfaceMesh& model, const energies::AnyEnergy& energy,
                              const Options& options, const Monitor& monitor) {
  options.validate();
  Parameterization p;
  p.domain = timed(p.times, "domain", [&] { return make_domain(model, options); });
  p.start = timed(p.times, "start", [&] { return make_start(p.domain, energy, options, monitor); });
  p.solution = timed(p.times, "solve", [&] { return solve(p.domain, p.start, energy, options, monitor); });
  p.split = timed(p.times, "overlap", [&] { return split_overlap(p.domain, p.start, p.solution, options); });
  p.layout = timed(p.times, "layout", [&] { return lay_out(p.domain, p.start, p.solution, options); });
  return p;
}

}  // namespace isostretch::parameterization
