#include <isostretch/core/error.hpp>
#include <isostretch/surface/check.hpp>

namespace isostretch::mesh {
namespace {

[[noreturn]] void not_a_disk(const std::string& why) {
  throw Error("the mesh is not a disk: " + why);
}

std::string with_others(const MeshDiagnostics& diagnostics, const Defect& defect) {
  const long others = diagnostics.count(defect.kind) - 1;
  if (others == 0) return defect.text;
  return defect.text + " (and " + std::to_string(others) + " more findings of the kind '" +
         std::string(defect_kind_name(defect.kind)) + "')";
}

}  // namespace

void require_disk(const MeshDiagnostics& diagnostics) {
  // DefectCollector come in the order of DefectKind: the cause before what follows from it.
  for (const Defect& defect : diagnostics.defects)
    if (defect.kind != DefectKind::zero_size && defect.kind != DefectKind::duplicate_vertex)
      not_a_disk(with_others(diagnostics, defect));
  if (diagnostics.components == 0) not_a_disk("it has no triangles");
  const std::string genus = std::to_string(diagnostics.genus);
  if (diagnostics.boundary_loops == 0)
    not_a_disk("it has no boundary (a closed surface of genus " + genus + "); cut it open first");
  if (diagnostics.genus != 0)
    not_a_disk("it has genus " + genus + ", that is " + genus + " handle(s); a disk has none");
  if (diagnostics.boundary_loops > 1)
    not_a_disk("it has " + std::to_string(diagnostics.boundary_loops) +
               " boundary loops; fill all holes but one");
}

void require_disk(const SurfaceMesh& mesh) {
  require_disk(check(mesh, 1));
}

}  // namespace isostretch::mesh
