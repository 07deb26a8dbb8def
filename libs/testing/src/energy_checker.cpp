#include <isostretch/testing/check_energy.hpp>
#include <isostretch/testing/deformation_samples.hpp>
#include <isostretch/testing/derivative_checks.hpp>
#include <isostretch/testing/eigensystem_checks.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <string>

namespace isostretch::testing::detail {
namespace {

template <int Dim>
class EnergyChecker {
 public:
  using Matrix = Eigen::Matrix<double, Dim, Dim>;
  using Vector = Eigen::Matrix<double, Dim * Dim, 1>;
  using PrincipalStretches = invariants::PrincipalStretches<Dim, double>;
  using Derivatives = invariants::StretchDerivatives<Dim, double>;

  EnergyChecker(const CheckedEnergy& energy, const EnergyCheckOptions& options, EnergyReport& report)
      : energy_(energy), options_(options), report_(report) {}

  void run() {
    facts_.dim = Dim;
    for (const auto& sample : deformation_samples<Dim>(options_.random_samples, options_.seed))
      check_sample(sample);
    check_rest();
    check_domain();
    report_.facts.push_back(facts_);
  }

 private:
  double psi(const Matrix& F) const { return energy_.psi(invariants::Modes<Dim>(F).stretch().sigma); }

  Derivatives derivatives(const PrincipalStretches& s) const {
    const PlainDerivatives plain = energy_.derivatives(s.sigma);
    Derivatives d;
    d.psi = plain.psi;
    for (int i = 0; i < Dim; ++i) d.gradient[i] = plain.gradient[i], d.diagonal[i] = plain.diagonal[i];
    for (int i = 0; i < d.pairs; ++i)
      d.twist[i] = plain.twist[i], d.flip[i] = plain.flip[i], d.coupling[i] = plain.coupling[i];
    return d;
  }

  Vector gradient(const Matrix& F) const {
    const invariants::Modes<Dim> modes(F);
    return assemble_gradient<Dim>(modes, derivatives(modes.stretch()));
  }

  /// Returns whether F is inside the domain with some room, and the energy there is a number that can be
  /// compared.
  bool usable(const Matrix& F) const {
    const double bound = energy_.determinant_bound(), J = F.determinant();
    if (!(J > bound + (std::isfinite(bound) ? 1e-12 : 0.0))) return false;
    return std::abs(psi(F)) < 1e100;
  }

  void check_sample(const DeformationSample<Dim>& sample) {
    if (!usable(sample.F)) return;
    sample_ = &sample;
    const invariants::Modes<Dim> modes(sample.F);
    const Derivatives d = derivatives(modes.stretch());
    check_finite(d);
    check_decoupled(d);
    check_psi(modes, d);
    if (!sample.smooth) return;
    check_witness(modes, d);
    if (sample.moderate) check_differences();
    if (modes.stretch()[Dim - 1] > 0) note_negative_modes(d);
  }

  void check_finite(const Derivatives& d) {
    double sum = d.psi;
    for (int i = 0; i < Dim; ++i) sum += d.gradient[i] * 0.0 + d.diagonal[i] * 0.0;
    for (int i = 0; i < d.pairs; ++i) sum += (d.twist[i] + d.flip[i] + d.coupling[i]) * 0.0;
    record("all derivatives finite", 0.5, std::isfinite(sum) ? 0.0 : 1.0);
  }

  void check_decoupled(const Derivatives& d) {
    if (!energy_.decoupled()) return;
    double largest = 0;
    for (int i = 0; i < d.pairs; ++i) largest = std::max(largest, std::abs(d.coupling[i]));
    record("decoupled: no coupling", 0.0, largest);
  }

  void check_psi(const invariants::Modes<Dim>& modes, const Derivatives& d) {
    const Matrix& F = sample_->F;
    const PrincipalStretches s = modes.stretch();
    double stiffness = 0;
    for (const double entry : d.diagonal) stiffness += std::abs(entry);
    const double scale = std::abs(d.psi) + assemble_gradient<Dim>(modes, d).norm() * F.norm() +
                         stiffness * F.squaredNorm() + 1e-300;
    const auto compare = [&](const char* what, double other) {
      record(what, options_.psi_tolerance, std::abs(other - d.psi) / scale);
    };
    std::mt19937 generator(options_.seed);
    const auto Q = random_rotation<Dim>(generator);
    compare("psi(F) is the psi of its derivatives", energy_.psi(s.sigma));
    compare("psi(Q F) = psi(F)", psi(Q * F));
    compare("psi(F Q) = psi(F)", psi(F * Q));
    PrincipalStretches turned;
    for (int i = 0; i < Dim; ++i) turned.sigma[i] = s.sigma[(i + 1) % Dim];
    compare("psi does not depend on the order of sigma", energy_.psi(turned.sigma));
    if (const auto other = energy_.psi_of_invariants(s.sigma); other && sample_->moderate)
      compare("psi(sigma) = psi(I1, I2, I3)", *other);
  }

  /// Returns the tolerance of the witness: the psi-only path and the long double differences lose digits on
  /// graded stretch; norms forgive most of it.
  double witness_tolerance() const {
    const double room = energy_.from_invariants() ? 1.0 : 1000.0;
    return options_.derivative_tolerance * room;
  }

  void check_witness(const invariants::Modes<Dim>& modes, const Derivatives& d) {
    EntryDerivatives<Dim> other;
    energy_.witness(sample_->F.data(), other.psi, other.gradient.data(), other.hessian.data());
    const double tolerance = witness_tolerance(), size = modes.svd.sigma[0];
    const double H_scale = other.hessian.norm(), g_scale = other.gradient.norm() + H_scale * size;
    record("psi = automatic", tolerance, std::abs(d.psi - other.psi) / (std::abs(d.psi) + g_scale * size));
    const Vector g = assemble_gradient<Dim>(modes, d);
    record("gradient = automatic", tolerance, (g - other.gradient).norm() / (g_scale + 1e-300));
    const EigensystemErrors e = compare_eigensystem<Dim>(analytic_eigenpairs<Dim>(modes, d), other.hessian);
    record("assembled Hessian = automatic", tolerance, e.hessian);
    record("eigenpairs: H v = lambda v", tolerance, e.residual);
    record("eigenvalues = numerical", tolerance, e.eigenvalues);
    record("clamp projection = numerical", tolerance, e.clamp);
    record("abs projection = numerical", tolerance, e.absolute);
  }

  void check_differences() {
    DifferenceOptions sweep;
    sweep.tolerance = options_.difference_tolerance;
    sweep.seed = options_.seed;
    const auto matrix = [](const Eigen::VectorXd& x) { return Matrix(Eigen::Map<const Matrix>(x.data())); };
    const auto psi_of = [&](const Eigen::VectorXd& x) { return psi(matrix(x)); };
    const auto gradient_of = [&](const Eigen::VectorXd& x) { return Eigen::VectorXd(gradient(matrix(x))); };
    const auto hessian_times = [&](const Eigen::VectorXd& x, const Eigen::VectorXd& v) {
      const invariants::Modes<Dim> modes(matrix(x));
      const auto pairs = analytic_eigenpairs<Dim>(modes, derivatives(modes.stretch()));
      return Eigen::VectorXd(assemble<Dim>(pairs, KeepEigenvalue{}) * Vector(v));
    };
    const Eigen::VectorXd x = invariants::vec<Dim>(sample_->F);
    const auto r = check_derivatives(psi_of, gradient_of, hessian_times, x, sweep);
    record("gradient = differences", sweep.tolerance, r.gradient.best_error);
    record("Hessian = differences", sweep.tolerance, r.hessian.best_error);
    const bool converges = r.gradient.ok(sweep) && r.hessian.ok(sweep);
    record("differences converge at second order", 0.5, converges ? 0.0 : 1.0);
  }

  void note_negative_modes(const Derivatives& d) {
    double scale = 0;
    Matrix A = Matrix::Zero();
    for (int i = 0; i < Dim; ++i) A(i, i) = d.diagonal[i], scale = std::max(scale, std::abs(d.diagonal[i]));
    for (int i = 0; i < d.pairs; ++i) {
      A(invariants::first<Dim>(i), invariants::second<Dim>(i)) = d.coupling[i];
      A(invariants::second<Dim>(i), invariants::first<Dim>(i)) = d.coupling[i];
      facts_.negative_twist |= d.twist[i] < -1e-10 * scale;
      facts_.negative_flip |= d.flip[i] < -1e-10 * scale;
    }
    facts_.negative_scaling |= linalg::symmetric_eigen<Dim>(A).lambda.minCoeff() < -1e-10 * A.norm();
  }

  /// Checks that a state without stress has no twist stiffness: rotating it costs nothing, to second order
  /// either.
  void check_rest() {
    sample_ = &rest_;
    PrincipalStretches s;
    for (int i = 0; i < Dim; ++i) s.sigma[i] = 1.0;
    const Derivatives d = derivatives(s);
    facts_.psi_at_rest = d.psi;
    double scale = 0;
    for (int i = 0; i < Dim; ++i) {
      facts_.stress_at_rest = std::hypot(facts_.stress_at_rest, d.gradient[i]);
      scale += std::abs(d.diagonal[i]);
    }
    for (int i = 0; i < d.pairs; ++i) {
      const double stress = d.gradient[invariants::first<Dim>(i)] + d.gradient[invariants::second<Dim>(i)];
      record("twist at rest = stress", 1e-13, std::abs(d.twist[i] - 0.5 * stress) / (scale + 1e-300));
    }
  }

  void check_domain() {
    const double bound = energy_.determinant_bound();
    Eigen::Matrix<double, Dim, 1> sigma = Eigen::Matrix<double, Dim, 1>::Ones();
    const auto at = [&](double determinant) {
      sigma[Dim - 1] = determinant;
      return energy_.guarded_psi(sigma.data());
    };
    record_domain("finite at rest", std::isfinite(at(1.0)));
    if (std::isfinite(bound)) {
      record_domain("+infinity at and beyond the bound",
                    at(bound) == infinity && at(bound - 0.5) == infinity && at(bound - 1e-9) == infinity);
      record_domain("grows without bound towards the bound",
                    diverges(at(bound + 1e-3), at(bound + 1e-6), at(bound + 1e-9)));
      record_domain("+infinity where F is not a number",
                    at(std::numeric_limits<double>::quiet_NaN()) == infinity);
    } else {
      record_domain("finite at zero and negative determinant",
                    std::isfinite(at(0.0)) && std::isfinite(at(-0.5)));
    }
  }

  /// Returns whether psi diverges, from values a factor of 1000 nearer to the bound each: a barrier keeps
  /// growing by at least as much (log J), a finite function grows a thousand times less.
  static bool diverges(double far, double near, double nearest) {
    return nearest == infinity || (near > far && nearest - near > 0.5 * (near - far));
  }

  void record_domain(const char* what, bool ok) {
    record(std::string("domain: ") + what, 0.5, ok ? 0.0 : 1.0);
  }

  void record(const std::string& what, double tolerance, double error) {
    auto check = std::find_if(report_.checks.begin(), report_.checks.end(),
                              [&](const EnergyCheck& c) { return c.dim == Dim && c.what == what; });
    if (check == report_.checks.end()) {
      report_.checks.push_back({Dim, what, tolerance, 0.0, "", 0});
      check = report_.checks.end() - 1;
    }
    ++check->samples;
    if (error <= check->worst || std::isnan(check->worst)) return;
    check->worst = error;
    std::ostringstream where;
    where.precision(17);
    where << sample_->category << ", vec(F) = " << invariants::vec<Dim>(sample_->F).transpose();
    check->where = where.str();
  }

  static constexpr double infinity = std::numeric_limits<double>::infinity();
  const CheckedEnergy& energy_;
  const EnergyCheckOptions& options_;
  EnergyReport& report_;
  const DeformationSample<Dim> rest_{"rest", Matrix::Identity(), true, true};
  const DeformationSample<Dim>* sample_ = &rest_;
  EnergyFacts facts_{};
};

}  // namespace

void run_checks(int dim, const CheckedEnergy& energy, const EnergyCheckOptions& options,
                EnergyReport& report) {
  if (dim == 2)
    EnergyChecker<2>(energy, options, report).run();
  else
    EnergyChecker<3>(energy, options, report).run();
}

}  // namespace isostretch::testing::detail
