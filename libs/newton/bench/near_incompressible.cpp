// Near-incompressible volumes with different eigenvalue filters: the scenarios that Chen et al. (2024) use
// for stable Neo-Hookean. Vertices are centred and scaled to the unit ball; slabs of width 0.1 at both ends
// of an axis are held, one of them displaced at once; everything else starts at rest.
//
//   isostretch_near_incompressible bob.mesh twist abs [option=value ...]
#include <isostretch/energies/registry.hpp>
#include <isostretch/fem/element_arrays.hpp>
#include <isostretch/mesh_io/io.hpp>
#include <isostretch/newton/minimize.hpp>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <map>
#include <string>

namespace {

using namespace isostretch;

constexpr double mu = 3.3344e7, lambda = 100 * mu;

struct Scenario {
  const char* name;
  int axis;           // of the slabs
  bool displace_max;  // the slab at the upper end moves
  double shift;       // times the extent along the axis
  double degrees;     // about that axis, through the mean of the slab
  double stop;        // Newton decrement, times lambda
};

constexpr Scenario scenarios[] = {{"twist", 0, true, 1.2, 90, 1e-5},
                                  {"compress_y", 1, true, -0.5, 0, 1e-5},
                                  {"compress_z", 2, true, -0.3, 0, 2e-6}};

const Scenario& scenario_named(const std::string& name) {
  for (const Scenario& s : scenarios)
    if (s.name == name) return s;
  throw Error("unknown scenario '" + name + "'; there are twist, compress_y, compress_z");
}

mesh::TetMesh normalised(mesh::TetMesh mesh) {
  mesh.vertices.rowwise() -= mesh.vertices.colwise().mean().eval();
  mesh.vertices /= mesh.vertices.rowwise().norm().maxCoeff();
  return mesh;
}

// Positions with one slab displaced, and both slabs pinned.
Vector pose(const mesh::TetMesh& mesh, const Scenario& s, newton::Objective& objective) {
  const auto coordinate = mesh.vertices.col(s.axis);
  const double low = coordinate.minCoeff(), high = coordinate.maxCoeff(), width = 0.1;
  mesh::Points3 x = mesh.vertices;
  std::vector<int> moving;
  for (int v = 0; v < x.rows(); ++v) {
    const bool at_low = coordinate[v]<low + width, at_high = coordinate[v]> high - width;
    if (at_low || at_high) objective.pin(v);
    if (s.displace_max ? at_high : at_low) moving.push_back(v);
  }
  Eigen::RowVector3d centre = Eigen::RowVector3d::Zero();
  for (const int v : moving) centre += x.row(v);
  centre /= static_cast<double>(moving.size());
  Eigen::Vector3d axis = Eigen::Vector3d::Zero();
  axis[s.axis] = 1;
  const double angle = s.degrees * std::acos(-1.0) / 180;
  Eigen::Matrix3d cross;
  cross << 0, -axis[2], axis[1], axis[2], 0, -axis[0], -axis[1], axis[0], 0;
  const Eigen::Matrix3d R =
      Eigen::Matrix3d::Identity() + std::sin(angle) * cross + (1 - std::cos(angle)) * cross * cross;
  for (const int v : moving) {
    x.row(v) = centre + (x.row(v) - centre) * R.transpose();
    x(v, s.axis) += s.shift * (high - low);
  }
  return Eigen::Map<const Vector>(x.data(), x.size());
}

newton::Options options_of(const Scenario& s, const std::string& projection) {
  newton::Options options;
  options.projection = newton::projection_from_name(projection);
  options.decrement_tolerance = s.stop * lambda;
  options.scaled_gradient_tolerance = 0;
  options.max_iterations = 200;
  options.armijo = 1e-8;
  return options;
}

void set(newton::Options& options, const std::string& text) {
  const auto equals = text.find('=');
  const std::string name = text.substr(0, equals);
  const std::string value = equals == std::string::npos ? "" : text.substr(equals + 1);
  if (name == "max_expansion")
    options.max_expansion = std::stod(value);
  else if (name == "backtracking_factor")
    options.backtracking_factor = std::stod(value);
  else if (name == "decrement")
    options.decrement_tolerance = std::stod(value) * lambda;
  else if (name == "solver")
    options.solver.backend = sparse::backend_from_name(value);
  else if (name == "preconditioner")
    options.solver.pcg_preconditioner = sparse::preconditioner_from_name(value);
  else if (name == "largest_forcing")
    options.largest_forcing = std::stod(value);
  else if (name == "retry_interval")
    options.retry_interval = std::stoi(value);
  else
    throw Error("unknown option '" + name + "'");
}

int run(int argc, char** argv) {
  if (argc < 4) throw Error("arguments: mesh, scenario, projection, option=value ...");
  const Scenario& scenario = scenario_named(argv[2]);
  const mesh::TetMesh mesh = normalised(mesh::read_tets(argv[1]));
  mesh::ElementArrays elements = mesh::elements(mesh);
  // 0.5 det(Dm) a tetrahedron, three times its volume, as published.
  for (double& weight : elements.weights) weight *= 3;
  newton::Objective objective(3, static_cast<int>(mesh.vertices.rows()));
  // mu/2 (|F|^2 - 3) + lambda/2 (J - alpha)^2, alpha = 1 + mu/lambda, is ours up to mu^2 / (2 lambda).
  objective.add<newton::EnergyTerm>(
      assembly::elements_from(elements),
      energies::make_energy("stable_neo_hookean", {{"mu", mu}, {"lambda", lambda}}));
  Vector x = pose(mesh, scenario, objective);
  newton::Options options = options_of(scenario, argv[3]);
  bool trace = false;
  for (int i = 4; i < argc; ++i)
    if (std::string(argv[i]) == "trace")
      trace = true;
    else
      set(options, argv[i]);
  const newton::Summary s = newton::minimize(objective, x, options);
  double volume = 0;
  for (const double weight : elements.weights) volume += weight;
  const double constant = volume * 0.5 * mu * mu / lambda;
  std::printf("%s %s %s: %s, %d iterations, %d evaluations, %d factorizations, energy %.5e\n", argv[1],
              argv[2], argv[3], std::string(newton::status_name(s.status)).c_str(), s.iterations,
              s.energy_evaluations, s.factorizations, s.energy + constant);
  std::printf("  seconds: total %.3f, assembly %.3f, factorization %.3f, solve %.3f, line search %.3f\n",
              s.seconds.total, s.seconds.assembly, s.seconds.factorization, s.seconds.solve,
              s.seconds.line_search);
  std::printf("  %s\n", s.solver.c_str());
  if (trace) std::printf("%s\n", s.full_report().c_str());
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
