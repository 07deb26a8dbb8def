// The summary and the verdict of a flattened surface.
#include "expect.hpp"

#include <isostretch/energies/registry.hpp>
#include <isostretch/mesh/generators.hpp>
#include <isostretch/reports/parameterization_report.hpp>

using namespace isostretch;

int main() {
  // snippet: libs/reports/README.md
  const energies::AnyEnergy energy = energies::make_energy("symmetric_dirichlet");
  const parameterization::Options options;
  const auto atlas = parameterization::parameterize(mesh::icosphere(3), energy, options);
  const reports::ParameterizationReport report{atlas, options, energy, "sphere.obj"};
  const std::string summary = reports::summary_text(report, {});  // what isostretch-parameterize writes
  const std::string said = reports::outcome(report);  // "6 charts; no triangle is turned over; ..."
  // end of snippet
  EXPECT(reports::status(report) == reports::RunStatus::success);
  EXPECT(reports::verdict(report).empty());
  EXPECT(summary.find("\"converged\": true") != std::string::npos);
  EXPECT(said.find("no triangle is turned over") != std::string::npos);
}
