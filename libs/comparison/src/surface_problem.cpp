#include "surface_problem.hpp"

#include "json.hpp"

#include <isostretch/core/error.hpp>
#include <isostretch/mesh/generators.hpp>
#include <isostretch/mesh_io/io.hpp>
#include <isostretch/parameterization/start.hpp>
#include <isostretch/scene/energy.hpp>
#include <isostretch/surface/check.hpp>

#include <limits>

namespace isostretch::comparison {
namespace {

namespace fs = std::filesystem;

struct Surface {
  std::string name;  // for messages and reports
  mesh::SurfaceMesh mesh;
};

// A file, or {"face": {"rings": N}}.
Surface read_surface(const scene::Node& value, const fs::path& folder) {
  if (!value.value().is_text()) {
    const int rings =
        value.only({"face"}).at("face").only({"rings"}).at("rings").whole(1, std::numeric_limits<int>::max());
    return {"face", naming(value, [&] { return mesh::procedural_face(rings); })};
  }
  const fs::path file = folder / value.text();
  return {file.string(),
          with_error_kind(ErrorKind::input, [&] { return mesh::read_surface(file.string()); })};
}

void require_disk(const Surface& surface) {
  try {
    mesh::require_disk(surface.mesh);
  } catch (const Error& error) {
    throw Error(ErrorKind::input, surface.name + ": " + error.what() +
                                      "; what is compared flattens disks: open the surface first, "
                                      "isostretch-parameterize can");
  }
}

// As isostretch-parameterize starts: Tutte's embedding with uniform weights on a circle, of the rest's area.
Vector tutte_start(const Surface& surface, const mesh::ElementArrays& rest) {
  const parameterization::StartResult start = parameterization::flip_free_start(surface.mesh, rest);
  if (start.uv.rows() == 0) throw Error("no start: " + start.message);
  return Eigen::Map<const Vector>(start.uv.data(), start.uv.size());
}

}  // namespace

Problem surface_problem(const scene::Node& value, const fs::path& folder) {
  value.only({"name", "mesh", "energy", "material"});
  const energies::AnyEnergy energy = scene::read_energy(value, 2);
  const Surface surface = read_surface(value.at("mesh"), folder);
  require_disk(surface);
  Problem problem{{},
                  {{}, energy, {}},
                  {},
                  record_of({{"kind", "surface"}, {"mesh", fs::path(surface.name).filename()}})};
  with_error_kind(ErrorKind::input, [&] {
    with_error_prefix(surface.name, [&] {
      mesh::ElementArrays rest = mesh::flat_elements(surface.mesh);
      mesh::scale_to_total_weight(rest, 1);
      problem.start = tutte_start(surface, rest);
      problem.distortion.elements = assembly::elements_from(std::move(rest));
    });
  });
  return problem;
}

}  // namespace isostretch::comparison
