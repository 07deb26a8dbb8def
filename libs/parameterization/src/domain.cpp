#include <isostretch/core/error.hpp>
#include <isostretch/core/log.hpp>
#include <isostretch/core/text.hpp>
#include <isostretch/mesh/require.hpp>
#include <isostretch/parameterization/domain.hpp>
#include <isostretch/surface/check.hpp>
#include <isostretch/surface/components.hpp>
#include <isostretch/surface/seams.hpp>

#include <algorithm>
#include <map>
#include <string>
#include <tuple>
#include <utility>

namespace isostretch::parameterization {
namespace {

mesh::CutOptions cut_options(const Domain& domain, const Options& options) {
  mesh::CutOptions cut;
  cut.holes = options.holes;
  cut.max_terminals = options.cut_tips;
  if (domain.seams_from_input) cut.seams = mesh::seams_of_uv(domain.input);
  return cut;
}

void explain_cut(const Domain& domain) {
  if (domain.cut.seams.empty()) return;
  std::string text = domain.seams_from_input ? "cut along the input's seams" : "cut open";
  text += ": " + counted(domain.cut.seams.size(), "edge") + ", " + counted(domain.cut.charts.size(), "chart");
  log(LogLevel::info, text);
}

void cut_open(Domain& domain, const mesh::MeshDiagnostics& diagnostics, const Options& options) {
  if (!options.cut) mesh::require_disk(diagnostics);
  domain.cut = mesh::cut_to_disks(domain.input, cut_options(domain, options));
  explain_cut(domain);
}

// The layout of the input has a vertex for every vertex and uv that meet at a corner: where two triangles
// have different uv at a vertex, the surface is cut there. Nothing has to be a disk.
void open_along_input_uv(Domain& domain) {
  const mesh::SurfaceMesh& input = domain.input;
  if (!input.has_uv()) throw Error("the model has no texture coordinates to start from (initial input)");
  // In the order of the input's vertices, so that a model without seams keeps its numbering.
  using Place = std::tuple<int, double, double>;
  const auto place = [&](Eigen::Index t, int c) {
    const auto uv = input.uv.row(input.uv_triangles(t, c));
    return Place(input.triangles(t, c), uv[0], uv[1]);
  };
  std::map<Place, int> numbers;
  for (Eigen::Index t = 0; t < input.triangles.rows(); ++t)
    for (int c = 0; c < 3; ++c) numbers.emplace(place(t, c), 0);
  int next = 0;
  for (auto& [corner, number] : numbers) number = next++;
  mesh::Cut& cut = domain.cut;
  cut.mesh.vertices.resize(next, 3);
  cut.mesh.triangles.resize(input.triangles.rows(), 3);
  domain.input_uv.resize(next, 2);
  for (const auto& [corner, number] : numbers) {
    cut.mesh.vertices.row(number) = input.vertices.row(std::get<0>(corner));
    domain.input_uv.row(number) << std::get<1>(corner), std::get<2>(corner);
    cut.original_vertex.push_back(std::get<0>(corner));
  }
  for (Eigen::Index t = 0; t < input.triangles.rows(); ++t)
    for (int c = 0; c < 3; ++c) cut.mesh.triangles(t, c) = numbers.at(place(t, c));
  cut.chart = mesh::component_of_triangles(cut.mesh.triangles, next);
  cut.charts.resize(1 + static_cast<std::size_t>(*std::max_element(cut.chart.begin(), cut.chart.end())));
  cut.seams = mesh::seams_of_uv(input);
  explain_cut(domain);
}

}  // namespace

Domain make_domain(const mesh::SurfaceMesh& model, const Options& options) {
  mesh::require_any(model.triangles, "triangle");  // readers make sure of this, others may not
  mesh::require_consistent(model);
  Domain domain;
  domain.input = model;
  const mesh::MeshDiagnostics diagnostics = mesh::check(domain.input, 1);
  domain.components = diagnostics.components;
  domain.boundary_loops = diagnostics.boundary_loops;
  domain.genus = diagnostics.genus;
  domain.closed = diagnostics.boundary_loops == 0;
  domain.seams_from_input = options.cut && (options.input_seams || options.initial == Initial::input) &&
                            domain.input.has_uv() && !mesh::seams_of_uv(domain.input).empty();
  if (options.initial == Initial::input)
    open_along_input_uv(domain);
  else
    cut_open(domain, diagnostics, options);
  return domain;
}

mesh::Points2 rows_of(const mesh::Points2& uv, const std::vector<int>& rows) {
  return uv(rows, Eigen::all);
}

int open_vertex(const Domain& domain, int input_vertex, const char* option) {
  const auto fail = [&](const std::string& why) {
    throw OptionError(option, "vertex " + std::to_string(input_vertex) + " " + why);
  };
  if (input_vertex >= domain.input.vertices.rows())
    fail("does not exist: the model has " + std::to_string(domain.input.vertices.rows()));
  int found = -1, copies = 0;
  const std::vector<int>& original = domain.cut.original_vertex;
  for (std::size_t v = 0; v < original.size(); ++v)
    if (original[v] == input_vertex) found = static_cast<int>(v), ++copies;
  if (copies == 0) fail("belongs to no triangle");
  if (copies > 1)
    fail("lies on a seam and has " + std::to_string(copies) + " copies in the layout; pin another");
  return found;
}

}  // namespace isostretch::parameterization
