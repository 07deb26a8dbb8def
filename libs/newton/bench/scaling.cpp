// Time and memory against size: a bar of 24 n^3 tetrahedra is held at one end, its other end is turned by a
// quarter and moved, everything between starts spread linearly. Prints one line of CSV.
//
//   isostretch_scaling n [energy] [solver=pcg] [preconditioner=amg] [projection=clamp] [largest_forcing=0.1]
#include <isostretch/energies/registry.hpp>
#include <isostretch/fem/element_arrays.hpp>
#include <isostretch/mesh/generators.hpp>
#include <isostretch/newton/minimize.hpp>

#include <sys/resource.h>

#include <cmath>
#include <cstdio>
#include <exception>
#include <string>

namespace {

using namespace isostretch;

// Twisted about the bar's axis and bent sideways by shares of the whole that grow along it.
Vector spread(const mesh::TetMesh& mesh) {
  const double quarter = 0.5 * std::acos(-1.0), length = mesh.vertices.col(0).maxCoeff();
  Vector x(3 * mesh.vertices.rows());
  for (int v = 0; v < mesh.vertices.rows(); ++v) {
    const double share = mesh.vertices(v, 0) / length, angle = share * quarter;
    const double y = mesh.vertices(v, 1) - 0.5, z = mesh.vertices(v, 2) - 0.5;
    x.segment<3>(3 * v) << mesh.vertices(v, 0) + 0.2 * share,
        0.5 + std::cos(angle) * y - std::sin(angle) * z + 0.5 * share,
        0.5 + std::sin(angle) * y + std::cos(angle) * z;
  }
  return x;
}

void set(newton::Options& options, const std::string& text) {
  const std::string name = text.substr(0, text.find('=')), value = text.substr(text.find('=') + 1);
  if (name == "solver")
    options.solver.backend = sparse::backend_from_name(value);
  else if (name == "preconditioner")
    options.solver.pcg_preconditioner = sparse::preconditioner_from_name(value);
  else if (name == "projection")
    options.projection = newton::projection_from_name(value);
  else if (name == "largest_forcing")
    options.largest_forcing = std::stod(value);
  else
    throw Error("unknown option '" + name + "'");
}

int run(int argc, char** argv) {
  if (argc < 2) throw Error("arguments: cells across, energy, option=value ...");
  const int n = std::stoi(argv[1]);
  const std::string energy = argc > 2 ? argv[2] : "symmetric_arap";
  newton::Options options;
  for (int i = 3; i < argc; ++i) set(options, argv[i]);
  const mesh::TetMesh mesh = mesh::tet_bar(4 * n, n, n, 4, 1, 1);
  newton::Objective objective(3, static_cast<int>(mesh.vertices.rows()));
  objective.add<newton::EnergyTerm>(assembly::elements_from(mesh::elements(mesh)),
                                    energies::make_energy(energy));
  for (int v = 0; v < mesh.vertices.rows(); ++v)
    if (mesh.vertices(v, 0) < 0.05 || mesh.vertices(v, 0) > 3.95) objective.pin(v);
  Vector x = spread(mesh);
  const newton::Summary s = newton::minimize(objective, x, options);
  rusage usage{};
  ::getrusage(RUSAGE_SELF, &usage);
  std::printf(
      "tets,unknowns,energy,solver,status,iterations,factorizations,result,seconds,setup,assembly,"
      "factorization,solve,line_search,peak_mb\n"
      "%ld,%d,%s,%s,%s,%d,%d,%.10g,%.3f,%.3f,%.3f,%.3f,%.3f,%.3f,%ld\n",
      static_cast<long>(mesh.tets.rows()), objective.zero_matrix().size, energy.c_str(), s.solver.c_str(),
      std::string(newton::status_name(s.status)).c_str(), s.iterations, s.factorizations, s.energy,
      s.seconds.total, s.seconds.setup, s.seconds.assembly, s.seconds.factorization, s.seconds.solve,
      s.seconds.line_search, usage.ru_maxrss / 1024);
  return newton::failed(s.status) ? 1 : 0;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
