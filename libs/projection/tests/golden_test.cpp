// Every golden record through the batch interface, at every instruction-set level: psi, stress, exact and
// clamped Hessian.
#include <isostretch/core/isa.hpp>
#include <isostretch/energies/registry.hpp>
#include <isostretch/projection/projection.hpp>

#include <doctest/doctest.h>

#include <Eigen/LU>

#include <algorithm>
#include <cmath>

#include "every_level.hpp"
#include "golden.hpp"

using namespace isostretch;
using projection::Filter;

namespace {

template <int Dim>
void check(const golden::Case& c, const golden::Record& record, double& worst) {
  const auto energy = energies::make_energy(record.energy, record.parameters);
  const Eigen::Matrix<double, Dim, Dim> F = c.F;
  const auto exact = projection::evaluate<Dim>(energy, F, {Filter::none});
  // Barrier energies end at det F = 0 here; their formulas beyond are tested in energies.
  if (energy.has_barrier() && !(F.determinant() > 0)) return;
  const auto clamped = projection::evaluate<Dim>(energy, F, {Filter::clamp});
  const auto accept = [&](const Eigen::MatrixXd& value, const golden::Quantity& reference, double scale) {
    const double needed = golden::needed_constant(value, reference, scale);
    CHECK(needed <= golden::acceptance);
    worst = std::max(worst, needed);
  };
  const double H_scale = record.H.value.reshaped().stableNorm();
  accept(Eigen::MatrixXd::Constant(1, 1, exact.psi), record.psi, std::abs(record.psi.value(0, 0)));
  accept(exact.P.reshaped(), record.grad, record.grad.value.stableNorm());
  accept(exact.H, record.H, H_scale);
  accept(clamped.H, record.HP, H_scale);
}

template <int Dim>
void check_all() {
  double worst = 0;
  int checked = 0;
  for (const auto& c : golden::read(Dim))
    for (const auto& record : c.records) {
      if (!record.comparable) continue;
      ++checked;
      CAPTURE(c.id);
      CAPTURE(record.energy);
      check<Dim>(c, record, worst);
    }
  CHECK(checked > 100);
  MESSAGE(isa_name(active_isa()) << ", " << Dim << "D: worst C " << worst);
}

}  // namespace

TEST_CASE("golden records: stress and Hessians, exact and clamped, of every instruction-set level") {
  tests::at_every_level([] {
    check_all<2>();
    check_all<3>();
  });
}
