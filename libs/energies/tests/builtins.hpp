#pragma once

// Every built-in energy as a type (the list is generated from the folder), and chunk evaluation of one point.

#include <isostretch/energies/any_energy.hpp>

#include <array>

#include "builtin_includes.inc"

#include "every_level.hpp"

namespace isostretch::energies::tests {

// visit(energy) for each built-in energy with its default parameters.
template <class Visitor>
void for_each_builtin(Visitor visit) {
#define ISOSTRETCH_ENERGY(Struct) visit(Struct{});
#include "builtin_list.inc"
#undef ISOSTRETCH_ENERGY
}

// The same with parameters that are neither 1 nor equal, so that no factor can hide.
template <class Visitor>
void for_each_varied_builtin(Visitor visit) {
  for_each_builtin([&](auto energy) {
    double factor = 1.1;
    energy.parameters([&](const char*, double& value, const char*) {
      value *= factor;
      factor += 0.3;
    });
    visit(energy);
  });
}

template <int Dim>
using Derivatives = StretchDerivatives<Dim, double>;

// visit(name, value of a, value of b) for each entry of two sets of derivatives.
template <int Dim, class A, class B, class Visitor>
void for_each_entry(const A& a, const B& b, Visitor visit) {
  for (int i = 0; i < Dim; ++i) {
    visit("gradient", a.gradient[i], b.gradient[i]);
    visit("diagonal", a.diagonal[i], b.diagonal[i]);
  }
  for (int i = 0; i < a.pairs; ++i) {
    visit("twist", a.twist[i], b.twist[i]);
    visit("flip", a.flip[i], b.flip[i]);
    visit("coupling", a.coupling[i], b.coupling[i]);
  }
}

// A chunk of one point, repeated in all lanes: the kernels of the active instruction-set level.
template <int Dim>
class PointChunk {
 public:
  explicit PointChunk(const PrincipalStretches<Dim, double>& s) {
    for (int e = 0; e < Dim; ++e)
      for (int i = 0; i < lanes; ++i) sigma_[static_cast<std::size_t>(e * lanes + i)] = s[e];
  }

  double psi(const AnyEnergy& energy) {
    energy.evaluate_psi(Dim, chunk());
    return psi_[lanes - 1];
  }

  Derivatives<Dim> derivatives(const AnyEnergy& energy) {
    energy.evaluate_derivatives(Dim, chunk());
    Derivatives<Dim> d;
    d.psi = psi_[lanes - 1];
    for (int e = 0; e < Dim; ++e) d.gradient[e] = last(gradient_, e), d.diagonal[e] = last(diagonal_, e);
    for (int e = 0; e < d.pairs; ++e) {
      d.twist[e] = last(twist_, e);
      d.flip[e] = last(flip_, e);
      d.coupling[e] = last(coupling_, e);
    }
    return d;
  }

 private:
  static constexpr int lanes = 8;
  using Entries = std::array<double, 3 * lanes>;

  static double last(const Entries& entries, int e) {
    return entries[static_cast<std::size_t>(e * lanes + lanes - 1)];
  }

  StretchChunk chunk() {
    StretchChunk c;
    c.count = c.stride = lanes;
    c.sigma = sigma_.data(), c.psi = psi_.data(), c.gradient = gradient_.data();
    c.twist = twist_.data(), c.flip = flip_.data(), c.diagonal = diagonal_.data(),
    c.coupling = coupling_.data();
    return c;
  }

  Entries sigma_{}, psi_{}, gradient_{}, twist_{}, flip_{}, diagonal_{}, coupling_{};
};

using isostretch::tests::at_every_level;

}  // namespace isostretch::energies::tests
