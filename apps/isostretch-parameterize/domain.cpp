#include "domain.hpp"

#include "common/exit_code.hpp"
#include "common/formatted.hpp"
#include "common/terminal.hpp"

#include <isostretch/mesh/weld.hpp>
#include <isostretch/mesh_io/io.hpp>
#include <isostretch/surface/check.hpp>
#include <isostretch/surface/components.hpp>
#include <isostretch/surface/seams.hpp>

#include <algorithm>
#include <cctype>
#include <map>
#include <sstream>
#include <string>
#include <tuple>
#include <utility>

namespace isostretch::app::parameterize {
namespace {

// Vertices of no triangle do no harm, and without them numbers would change.
constexpr mesh::RepairOptions repairs{.split_vertices = true, .remove_unreferenced = false};

void repair_input(Domain& domain) {
  domain.repairs = mesh::repair(domain.input, repairs);
  std::istringstream lines(to_text(domain.repairs));
  for (std::string line; std::getline(lines, line);) notice("repair: " + line);
}

bool repair_would_help(mesh::SurfaceMesh mesh) {
  try {
    mesh::repair(mesh, repairs);
    mesh::cut_to_disks(mesh);
    return true;
  } catch (const Error&) {
    return false;
  }
}

bool is_obj(const std::filesystem::path& file) {
  std::string extension = file.extension().string();
  for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return extension == ".obj";
}

int pieces_of(const mesh::SurfaceMesh& mesh) {
  const std::vector<int> piece =
      mesh::component_of_triangles(mesh.triangles, static_cast<int>(mesh.vertices.rows()));
  return piece.empty() ? 0 : 1 + *std::max_element(piece.begin(), piece.end());
}

// Some exporters give every face vertices of its own.
void tell_of_coincident_points(const Domain& domain) {
  const int pieces = pieces_of(domain.input);
  if (pieces < 2) return;
  mesh::SurfaceMesh welded = domain.input;
  const int doubled = mesh::weld(welded);
  if (doubled == 0 || pieces_of(welded) == pieces) return;
  notice(std::to_string(doubled) + (doubled == 1 ? " vertex is" : " vertices are") +
         " at the place of others, so that the surface comes in " +
         counted(static_cast<std::size_t>(pieces), "piece") + " instead of " +
         std::to_string(pieces_of(welded)) + "; --weld takes them for one");
}

Domain read_input(const Options& options) {
  Domain domain;
  const mesh::ReadOptions how{.leave_out_faces = options.repair,
                              .face_advice = "; --repair leaves it out",
                              .read_uv = options.initial == Initial::input || options.input_seams};
  if (is_obj(options.model)) {
    domain.document =
        std::make_shared<const mesh::ObjDocument>(mesh::ObjDocument::read(options.model.string(), how));
    domain.input = domain.document->mesh();
  } else {
    domain.input = mesh::read_surface(options.model.string(), how);
  }
  naming_file(options.model, [&] {
    if (options.weld)
      notice("weld: " + std::to_string(mesh::weld(domain.input, *options.weld)) +
             " vertices taken for others");
    else
      tell_of_coincident_points(domain);
    if (options.repair) repair_input(domain);
  });
  return domain;
}

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
  notice(text);
}

void cut_open(Domain& domain, const mesh::Report& report, const Options& options) {
  if (!options.cut) mesh::require_disk(report);
  try {
    domain.cut = mesh::cut_to_disks(domain.input, cut_options(domain, options));
  } catch (const Error& error) {
    if (options.repair || !repair_would_help(domain.input)) throw;
    throw Error(std::string(error.what()) + "; --repair mends that");
  }
  explain_cut(domain);
}

// The layout of the input has a vertex for every vertex and uv that meet at a corner: where two triangles
// have different uv at a vertex, the surface is cut there. Nothing has to be a disk.
void open_along_input_uv(Domain& domain) {
  const mesh::SurfaceMesh& input = domain.input;
  if (!input.has_uv()) throw Error("--initial input: the model has no texture coordinates");
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

namespace {

// Several components and vertices of no triangle are no obstacle.
bool flattenable(const mesh::Report& report) {
  long obstacles = 0;
  for (const long count : report.counts) obstacles += count;
  for (const mesh::Kind kind :
       {mesh::Kind::several_components, mesh::Kind::unreferenced_vertex, mesh::Kind::duplicate_vertex})
    obstacles -= report.count(kind);
  return obstacles == 0;
}

}  // namespace

std::string check_report(const Options& options, bool& clean) {
  return failing_with(ExitCode::input, [&] {
    const mesh::Report report = mesh::check(read_input(options).input);
    clean = flattenable(report);
    return to_text(report);
  });
}

Domain read_domain(const Options& options) {
  return failing_with(ExitCode::input, [&] {
    Domain domain = read_input(options);
    naming_file(options.model, [&] {
      const mesh::Report report = mesh::check(domain.input, 1);
      domain.components = report.components;
      domain.boundary_loops = report.boundary_loops;
      domain.genus = report.genus;
      domain.closed = report.boundary_loops == 0;
      domain.seams_from_input =
          options.cut && domain.input.has_uv() && !mesh::seams_of_uv(domain.input).empty();
      if (options.initial == Initial::input)
        open_along_input_uv(domain);
      else
        cut_open(domain, report, options);
    });
    return domain;
  });
}

mesh::Points2 rows_of(const mesh::Points2& uv, const std::vector<int>& rows) {
  return uv(rows, Eigen::all);
}

int open_vertex(const Domain& domain, int input_vertex, const char* option) {
  const auto fail = [&](const std::string& why) {
    throw Failure(ExitCode::command_line,
                  std::string(option) + ": vertex " + std::to_string(input_vertex) + " " + why);
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

}  // namespace isostretch::app::parameterize
