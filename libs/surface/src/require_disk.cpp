#include <isostretch/core/error.hpp>
#include <isostretch/surface/check.hpp>

namespace isostretch::mesh {
namespace {

[[noreturn]] void not_a_disk(const std::string& why) {
  throw Error("the mesh is not a disk: " + why);
}

std::string with_others(const Report& report, const Finding& finding) {
  const long others = report.count(finding.kind) - 1;
  if (others == 0) return finding.text;
  return finding.text + " (and " + std::to_string(others) + " more findings of the kind '" +
         std::string(kind_name(finding.kind)) + "')";
}

}  // namespace

void require_disk(const Report& report) {
  // Findings come in the order of Kind: the cause before what follows from it.
  for (const Finding& finding : report.findings)
    if (finding.kind != Kind::zero_size && finding.kind != Kind::duplicate_vertex)
      not_a_disk(with_others(report, finding));
  if (report.components == 0) not_a_disk("it has no triangles");
  const std::string genus = std::to_string(report.genus);
  if (report.boundary_loops == 0)
    not_a_disk("it has no boundary (a closed surface of genus " + genus + "); cut it open first");
  if (report.genus != 0)
    not_a_disk("it has genus " + genus + ", that is " + genus + " handle(s); a disk has none");
  if (report.boundary_loops > 1)
    not_a_disk("it has " + std::to_string(report.boundary_loops) + " boundary loops; fill all holes but one");
}

void require_disk(const SurfaceMesh& mesh) {
  require_disk(check(mesh, 1));
}

}  // namespace isostretch::mesh
