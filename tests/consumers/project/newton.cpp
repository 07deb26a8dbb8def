// A curved cap flattened; the eight lines of the top-level README.
#include "expect.hpp"

#include <isostretch/energies/registry.hpp>
#include <isostretch/fem/element_arrays.hpp>
#include <isostretch/mesh/generators.hpp>
#include <isostretch/mesh_io/io.hpp>
#include <isostretch/newton/minimize.hpp>
#include <isostretch/parameterization/tutte.hpp>
#include <isostretch/surface/orientation.hpp>

#include <cstdio>
#include <utility>

using namespace isostretch;

static newton::Summary flatten(const char* file, mesh::Points2& uv) {
  // clang-format off
  // snippet: README.md
  auto model = mesh::read_surface(file);                      // a topological disk
  auto start = parameterization::tutte_embedding(model).uv;               // flip-free
  auto rest = mesh::flat_elements(model);                     // rest shape of every triangle
  mesh::scale_to_total_weight(rest, 1.0);
  newton::Objective objective(2, rest.node_count);
  objective.add<newton::EnergyTerm>(assembly::elements_from(rest), energies::make_energy("symmetric_dirichlet"));
  Eigen::VectorXd x = Eigen::VectorXd::Map(start.data(), start.size());
  auto summary = newton::minimize(objective, x);              // x: u and v, vertex by vertex
  // end of snippet
  // clang-format on

  // The callback sees the positions, and may stop.
  Eigen::VectorXd seen, y = x;
  newton::Options options;
  options.gradient_tolerance = 1e-12;
  newton::minimize(objective, y, options, [&](const newton::Iteration&, const Eigen::VectorXd& positions) {
    seen = 2.0 * positions - positions.reverse();
    return newton::CallbackAction::stop;
  });
  EXPECT((seen - (2.0 * x - x.reverse())).norm() < 1e-6);

  uv = Eigen::Map<const mesh::Points2>(x.data(), start.rows(), 2);
  return summary;
}

// A term of one's own: a constant force on every node, and a spring to the origin that ties the solution
// down.
class Pull final : public newton::Term {
 public:
  explicit Pull(Vector force) : force_(std::move(force)) {}
  void add_stencil(assembly::PatternBuilder&) const override {}  // nodes have their diagonal blocks
  void set_pattern(const assembly::HessianPattern& pattern) override { pattern_ = &pattern; }
  assembly::Evaluation value(const Vector& x) override {
    assembly::Evaluation at;
    at.value = 0.5 * x.squaredNorm() - force_.dot(x);
    return at;
  }
  assembly::Evaluation differentiate(const Vector& x, const projection::FilterOptions&, Vector& gradient,
                                     bool) override {
    gradient += x - force_;
    return value(x);
  }
  void add_hessian(double* values) const override {
    for (int node = 0; node < force_.size() / 2; ++node) {
      const int* positions = pattern_->positions(pattern_->block(node, node));
      for (int axis = 0; axis < 2; ++axis) values[positions[3 * axis]] += 1;
    }
  }

 private:
  Vector force_;
  const assembly::HessianPattern* pattern_ = nullptr;
};

static void own_term() {
  for (int nodes = 1; nodes < 40; ++nodes) {  // every alignment of memory and every remainder of a pack
    newton::Objective objective(2, nodes);
    const Vector force = Vector::LinSpaced(2 * nodes, -1.0, 2.0);
    objective.add<Pull>(force);
    Vector x = Vector::Zero(2 * nodes);
    EXPECT(newton::minimize(objective, x).converged());
    EXPECT((x - force).norm() < 1e-6 * force.norm());
  }
}

int main() {
  own_term();
  const auto cap = mesh::procedural_face(12);
  const char* file = "cap.obj";
  mesh::write_obj(file, cap);
  mesh::Points2 uv;
  const auto summary = flatten(file, uv);
  std::remove(file);
  EXPECT(summary.converged());
  EXPECT(summary.energy < summary.initial_energy);
  EXPECT(mesh::count_flipped(uv, cap.triangles) == 0);
}
