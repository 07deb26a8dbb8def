// Does a free body come back to rest? From positions that are random, collapsed, flattened or mirrored, at
// any stiffness: prints how, and how far from rest it ends.
//
//   isostretch_rest_recovery hand.mesh arap random nu=0.49 young=1e6 [first=arap] [projection=abs] [trace]
#include <isostretch/energies/registry.hpp>
#include <isostretch/fem/element_arrays.hpp>
#include <isostretch/mesh/generators.hpp>
#include <isostretch/mesh_io/io.hpp>
#include <isostretch/newton/minimize.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <map>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace isostretch;

struct Material {
  double young = 1, nu = 0.3;
  double mu() const { return young / (2 * (1 + nu)); }
  double lambda() const { return young * nu / ((1 + nu) * (1 - 2 * nu)); }
};

energies::AnyEnergy energy_of(const std::string& name, const Material& m) {
  // Names of parameters differ, their meaning is the same Hooke's law at small strain (arap has no volume
  // term).
  if (name == "arap") return energies::make_energy(name);
  if (name == "corotational") return energies::make_energy(name, {{"mu", m.mu()}, {"kappa", m.lambda()}});
  if (name == "stable_neo_hookean")
    return energies::make_energy(name, {{"mu", m.mu()}, {"lambda", m.lambda() + m.mu()}});
  return energies::make_energy(name, {{"mu", m.mu()}, {"lambda", m.lambda()}});
}

mesh::TetMesh unit_size(mesh::TetMesh mesh) {
  const Eigen::RowVector3d low = mesh.vertices.colwise().minCoeff(),
                           high = mesh.vertices.colwise().maxCoeff();
  mesh.vertices.rowwise() -= low;
  mesh.vertices /= (high - low).maxCoeff();
  return mesh;
}

mesh::Points3 start(const mesh::TetMesh& mesh, const std::string& kind) {
  mesh::Points3 x = mesh.vertices;
  if (kind == "random") {
    std::mt19937 generator(1);
    for (int v = 0; v < x.rows(); ++v)
      for (int c = 0; c < 3; ++c) x(v, c) = static_cast<double>(generator()) / 4294967296.0;
  } else if (kind == "point") {
    x.setConstant(0.5);
  } else if (kind == "plane") {
    x.col(1).setConstant(0.5);
  } else if (kind == "mirrored") {
    x.col(0) *= -1;
  } else if (kind != "rest") {
    throw Error("unknown start '" + kind + "'; there are random, point, plane, mirrored, rest");
  }
  return x;
}

struct Relaxed {
  newton::Summary summary;
  std::vector<double> stretches;
};

Relaxed relax(const mesh::TetMesh& mesh, const std::string& energy, const Material& material,
              const newton::Options& options, Vector& x) {
  mesh::ElementArrays arrays = mesh::elements(mesh);
  if (energy == "arap")  // which has no parameters: stiffness as a factor
    for (double& weight : arrays.weights) weight *= material.mu();
  newton::Objective objective(3, arrays.node_count);
  const auto& term =
      objective.add<newton::EnergyTerm>(assembly::elements_from(arrays), energy_of(energy, material));
  newton::Summary summary = newton::minimize(objective, x, options);
  return {std::move(summary), term.assembler().stretches(x.data())};
}

int run(int argc, char** argv) {
  if (argc < 4) throw Error("arguments: mesh (or bar), energy, start, option=value ...");
  const std::string path = argv[1];
  Material material;
  newton::Options options;
  bool trace = false, arap_first = false;
  for (int i = 4; i < argc; ++i) {
    const std::string text = argv[i], name = text.substr(0, text.find('=')),
                      value = text.substr(std::min(text.size(), name.size() + 1));
    if (name == "nu")
      material.nu = std::stod(value);
    else if (name == "young")
      material.young = std::stod(value);
    else if (name == "projection")
      options.projection = newton::projection_from_name(value);
    else if (name == "first" && value == "arap")
      arap_first = true;
    else if (name == "trace")
      trace = true;
    else
      throw Error("unknown option '" + name + "'");
  }
  const mesh::TetMesh mesh =
      unit_size(path == "bar" ? mesh::tet_bar(16, 4, 4, 4, 1, 1) : mesh::read_tets(path));
  const mesh::Points3 positions = start(mesh, argv[3]);
  Vector x = Eigen::Map<const Vector>(positions.data(), positions.size());
  options.max_iterations = 1000;
  options.scaled_gradient_tolerance = 1e-9;
  int iterations_before = 0;
  if (arap_first) iterations_before = relax(mesh, "arap", material, options, x).summary.iterations;
  const auto [s, sigma] = relax(mesh, argv[2], material, options, x);
  double worst = 0;
  int inverted = 0;
  for (std::size_t i = 0; i < sigma.size(); i += 3) {
    for (int k = 0; k < 3; ++k) worst = std::max(worst, std::abs(sigma[i + static_cast<std::size_t>(k)] - 1));
    inverted += sigma[i + 2] < 0;
  }
  std::printf(
      "%-12s %-20s %-8s nu %-5g E %-5g: %s, %d + %d it, %d fact, %.2f s, |sigma - 1| <= %.1e, %d inverted\n",
      path.substr(path.rfind('/') + 1).c_str(), argv[2], argv[3], material.nu, material.young,
      std::string(newton::status_name(s.status)).c_str(), iterations_before, s.iterations, s.factorizations,
      s.seconds.total, worst, inverted);
  if (trace) std::printf("%s\n", s.full_report().c_str());
  return std::isfinite(worst) ? 0 : 1;
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
