#include "input.hpp"

#include "common/terminal.hpp"

#include <isostretch/core/error.hpp>
#include <isostretch/core/text.hpp>
#include <isostretch/mesh/weld.hpp>
#include <isostretch/mesh_io/io.hpp>
#include <isostretch/surface/components.hpp>
#include <isostretch/surface/cut.hpp>

#include <algorithm>
#include <cctype>
#include <sstream>
#include <string>

namespace isostretch::app::parameterize {
namespace {

// Vertices of no triangle do no harm, and without them numbers would change.
constexpr mesh::RepairOptions repairs{.split_vertices = true, .remove_unreferenced = false};

void repair_input(Input& input) {
  input.repairs = mesh::repair(input.mesh, repairs);
  std::istringstream lines(to_text(input.repairs));
  for (std::string line; std::getline(lines, line);) notice("repair: " + line);
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
void tell_of_coincident_points(const mesh::SurfaceMesh& mesh) {
  const int pieces = pieces_of(mesh);
  if (pieces < 2) return;
  mesh::SurfaceMesh welded = mesh;
  const int doubled = mesh::weld(welded);
  if (doubled == 0 || pieces_of(welded) == pieces) return;
  notice(std::to_string(doubled) + (doubled == 1 ? " vertex is" : " vertices are") +
         " at the place of others, so that the surface comes in " +
         counted(static_cast<std::size_t>(pieces), "piece") + " instead of " +
         std::to_string(pieces_of(welded)) + "; --weld takes them for one");
}

}  // namespace

Input read_input(const Options& options) {
  Input input;
  const mesh::ReadOptions how{.leave_out_faces = options.repair,
                              .face_advice = "; --repair leaves it out",
                              .read_uv = options.initial == Initial::input || options.input_seams};
  if (is_obj(options.model)) {
    input.document =
        std::make_shared<const mesh::ObjDocument>(mesh::ObjDocument::read(options.model.string(), how));
    input.mesh = input.document->mesh();
  } else {
    input.mesh = mesh::read_surface(options.model.string(), how);
  }
  with_error_prefix(options.model.string(), [&] {
    if (options.weld)
      notice("weld: " + std::to_string(mesh::weld(input.mesh, *options.weld)) + " vertices taken for others");
    else
      tell_of_coincident_points(input.mesh);
    if (options.repair) repair_input(input);
  });
  return input;
}

bool repair_would_help(mesh::SurfaceMesh mesh) {
  const auto can_be_cut = [](const mesh::SurfaceMesh& surface) {
    try {
      mesh::cut_to_disks(surface);
      return true;
    } catch (const Error&) {
      return false;
    }
  };
  if (can_be_cut(mesh)) return false;
  mesh::repair(mesh, repairs);
  return can_be_cut(mesh);
}

bool flattenable(const mesh::MeshDiagnostics& report) {
  long obstacles = 0;
  for (const long count : report.counts) obstacles += count;
  for (const mesh::DefectKind kind :
       {mesh::DefectKind::several_components, mesh::DefectKind::unreferenced_vertex,
        mesh::DefectKind::duplicate_vertex})
    obstacles -= report.count(kind);
  return obstacles == 0;
}

}  // namespace isostretch::app::parameterize
