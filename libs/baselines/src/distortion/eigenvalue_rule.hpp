#pragma once

#include <isostretch/energies/any_energy.hpp>

#include <cmath>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace isostretch::baselines {

// An energy whose value and stress are its own, but the eigenvalues of whose Hessian a rule has changed: a
// method that differs from others in these alone runs on the same kernels as they do.
//
// A Rule is a struct with
//   template <int Dim> void operator()(const Stretch<Dim, double>&, StretchDerivatives<Dim, double>&) const;
// which changes twist, flip, diagonal and coupling in place.
template <class Rule>
class RuledEnergy final : public energies::ChunkEnergy {
 public:
  explicit RuledEnergy(energies::AnyEnergy energy, Rule rule = {})
      : energy_(std::move(energy)), rule_(std::move(rule)) {}

  std::string name() const override { return energy_.name(); }
  bool supports(int dim) const override { return energy_.supports(dim); }
  double determinant_bound() const override { return energy_.determinant_bound(); }
  bool coupled() const override { return energy_.coupled(); }
  std::vector<energies::Parameter> parameters() const override { return energy_.parameters(); }

  void psi(int dim, const energies::StretchChunk& chunk) const override { energy_.evaluate_psi(dim, chunk); }
  void derivatives(int dim, const energies::StretchChunk& chunk) const override {
    energy_.evaluate_derivatives(dim, chunk);
    if (dim == 2)
      apply<2>(chunk);
    else
      apply<3>(chunk);
  }

 private:
  template <int Dim>
  void apply(const energies::StretchChunk& chunk) const {
    for (int i = 0; i < chunk.count; ++i) {
      if (!std::isfinite(chunk.psi[i])) continue;  // derivatives are unspecified outside the domain
      const auto at = [&](auto* data, int entry) -> auto& {
        return data[static_cast<std::size_t>(entry) * chunk.stride + static_cast<std::size_t>(i)];
      };
      invariants::PrincipalStretches<Dim, double> s;
      invariants::StretchDerivatives<Dim, double> d;
      d.psi = chunk.psi[i];
      for (int e = 0; e < Dim; ++e) {
        s.sigma[e] = at(chunk.sigma, e);
        d.gradient[e] = at(chunk.gradient, e);
        d.diagonal[e] = at(chunk.diagonal, e);
      }
      for (int e = 0; e < d.pairs; ++e) {
        d.twist[e] = at(chunk.twist, e);
        d.flip[e] = at(chunk.flip, e);
        d.coupling[e] = at(chunk.coupling, e);
      }
      rule_(s, d);
      for (int e = 0; e < Dim; ++e) at(chunk.diagonal, e) = d.diagonal[e];
      for (int e = 0; e < d.pairs; ++e) {
        at(chunk.twist, e) = d.twist[e];
        at(chunk.flip, e) = d.flip[e];
        at(chunk.coupling, e) = d.coupling[e];
      }
    }
  }

  energies::AnyEnergy energy_;
  Rule rule_;
};

template <class Rule>
energies::AnyEnergy with_rule(energies::AnyEnergy energy, Rule rule = {}) {
  return energies::AnyEnergy(std::make_shared<const RuledEnergy<Rule>>(std::move(energy), std::move(rule)));
}

}  // namespace isostretch::baselines
