#include "domain.hpp"

#include "common/exit_code.hpp"
#include "common/terminal.hpp"

#include <isostretch/mesh/check.hpp>
#include <isostretch/mesh/cut.hpp>
#include <isostretch/mesh/io.hpp>

#include <map>
#include <numeric>
#include <string>
#include <utility>

namespace isostretch::app::parameterize {
namespace {

bool closed_sphere(const mesh::Report& report) {
  return report.indices_valid && report.components == 1 && report.boundary_loops == 0 && report.genus == 0;
}

void keep_closed_or_cut(Domain& domain, const mesh::Report& report, bool cut) {
  if (!cut || !closed_sphere(report)) {
    mesh::require_disk(report);
    domain.open = domain.input;
    domain.original_vertex.resize(static_cast<std::size_t>(domain.input.vertices.rows()));
    std::iota(domain.original_vertex.begin(), domain.original_vertex.end(), 0);
    return;
  }
  mesh::CutResult result = mesh::cut_to_disk_simple(domain.input);
  domain.cut_edges = static_cast<int>(result.path.size()) - 1;
  domain.open = std::move(result.mesh);
  domain.original_vertex = std::move(result.original_vertex);
  notice("the surface is closed: cut open along " + std::to_string(domain.cut_edges) + " edges from vertex " +
         std::to_string(result.path.front()) + " to vertex " + std::to_string(result.path.back()));
}

// The layout of the input has a vertex for every pair of a vertex and a uv point that meet at a corner: where
// two triangles use different uv points at a vertex, the surface is cut there.
void open_along_seams(Domain& domain) {
  const mesh::SurfaceMesh& input = domain.input;
  if (!input.has_uv()) throw Error("--initial input: the model has no texture coordinates");
  std::map<std::pair<int, int>, int> numbers;
  domain.open.triangles.resize(input.triangles.rows(), 3);
  // A model without seams keeps its numbering: vertices first come in the order of the input.
  for (Eigen::Index t = 0; t < input.triangles.rows(); ++t)
    for (int c = 0; c < 3; ++c)
      numbers.emplace(std::pair(input.triangles(t, c), input.uv_triangles(t, c)), 0);
  int next = 0;
  for (auto& [pair, number] : numbers) number = next++;
  domain.open.vertices.resize(next, 3);
  domain.input_uv.resize(next, 2);
  for (const auto& [pair, number] : numbers) {
    domain.open.vertices.row(number) = input.vertices.row(pair.first);
    domain.input_uv.row(number) = input.uv.row(pair.second);
    domain.original_vertex.push_back(pair.first);
  }
  for (Eigen::Index t = 0; t < input.triangles.rows(); ++t)
    for (int c = 0; c < 3; ++c)
      domain.open.triangles(t, c) = numbers.at({input.triangles(t, c), input.uv_triangles(t, c)});
  const auto seams = domain.open.vertices.rows() - input.vertices.rows();
  if (seams > 0)
    notice("the input's uv has seams: " + std::to_string(seams) + " more uv points than vertices");
}

}  // namespace

Domain read_domain(const Options& options) {
  return failing_with(ExitCode::input, [&] {
    Domain domain;
    const bool with_uv = options.initial == Initial::input;
    domain.input = mesh::read_surface(options.model.string(),
                                      {.triangulate_polygons = options.triangulate, .read_uv = with_uv});
    const mesh::Report report = mesh::check(domain.input, 1);
    domain.boundary_loops = report.boundary_loops;
    naming_file(options.model, [&] {
      if (with_uv)
        open_along_seams(domain);
      else
        keep_closed_or_cut(domain, report, options.cut);
    });
    return domain;
  });
}

int open_vertex(const Domain& domain, int input_vertex, const char* option) {
  const auto fail = [&](const std::string& why) {
    throw Failure(ExitCode::command_line,
                  std::string(option) + ": vertex " + std::to_string(input_vertex) + " " + why);
  };
  if (input_vertex >= domain.input.vertices.rows())
    fail("does not exist: the model has " + std::to_string(domain.input.vertices.rows()));
  int found = -1, copies = 0;
  for (std::size_t v = 0; v < domain.original_vertex.size(); ++v)
    if (domain.original_vertex[v] == input_vertex) found = static_cast<int>(v), ++copies;
  if (copies == 0) fail("belongs to no triangle");
  if (copies > 1)
    fail("lies on a cut and has " + std::to_string(copies) + " copies in the layout; pin another");
  return found;
}

}  // namespace isostretch::app::parameterize
