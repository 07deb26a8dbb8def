#include <isostretch/energies/registry.hpp>
#include <isostretch/expressions/expression.hpp>
#include <isostretch/projection/projection.hpp>
#include <isostretch/testing/check_energy.hpp>

#include <doctest/doctest.h>

using namespace isostretch;
using expressions::parse_energy;

TEST_SUITE("expressions") {
  TEST_CASE("first light") {
    const auto typed =
        parse_energy("mu/2*(I2 - d) - mu*log(J) + lambda/2*log(J)^2", {{"mu", 1}, {"lambda", 10}});
    const auto built = energies::make_energy("neo_hookean_log", {{"mu", 1}, {"lambda", 10}});
    CHECK(typed.has_barrier());
    Eigen::Matrix3d F;
    F << 1.1, 0.2, 0, -0.1, 0.8, 0.3, 0.1, 0, 1.3;
    const auto a = projection::evaluate<3>(typed, F), b = projection::evaluate<3>(built, F);
    CHECK(a.psi == doctest::Approx(b.psi).epsilon(1e-13));
    CHECK((a.P - b.P).norm() < 1e-13 * b.P.norm());
    CHECK((a.H - b.H).norm() < 1e-13 * b.H.norm());
    const auto valanis =
        parse_energy("mu*sum(log(s)^2) + lambda/2*sum(log(s))^2", {{"mu", 1}, {"lambda", 10}});
    const auto hencky = energies::make_energy("hencky", {{"mu", 1}, {"lambda", 10}});
    const auto c = projection::evaluate<3>(valanis, F), e = projection::evaluate<3>(hencky, F);
    CHECK((c.P - e.P).norm() < 1e-13 * e.P.norm());
    CHECK((c.H - e.H).norm() < 1e-13 * e.H.norm());
  }
}
