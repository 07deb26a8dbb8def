// Compiled once per instruction-set level: see cmake/IsostretchKernels.cmake for what may be included here.
#include "kernel_table.hpp"

#include <isostretch/energies/chunk_access.hpp>
#include <isostretch/invariants/partials.hpp>

namespace isostretch::expressions::ISOSTRETCH_KERNELS {
namespace {

using energies::load_stretch;
using energies::store_derivatives;
using invariants::Partials;
using invariants::PrincipalStretches;
using invariants::StretchDerivatives;

// One operation over all points of a chunk.
class Machine {
 public:
  Machine(const Task& task, const energies::StretchChunk& chunk) : task_(task), chunk_(chunk) {}

  template <int Dim>
  void run() {
    for (std::size_t i = 0; i < task_.length; ++i) step<Dim>(task_.code[i]);
  }

 private:
  double* at(std::uint16_t r) const { return task_.registers + static_cast<std::size_t>(r) * chunk_.stride; }

  template <class Function>
  ISOSTRETCH_INLINE void unary(const Instruction& in, const Function& f) const {
    const double* a = at(in.a);
    double* to = at(in.to);
    for (int i = 0; i < chunk_.count; i += lanes) store(to + i, f(load<Pack>(a + i)));
  }
  template <class Function>
  ISOSTRETCH_INLINE void binary(const Instruction& in, const Function& f) const {
    const double *a = at(in.a), *b = at(in.b);
    double* to = at(in.to);
    const Pack value(in.value);
    if (in.immediate == Instruction::Immediate::second)
      for (int i = 0; i < chunk_.count; i += lanes) store(to + i, f(load<Pack>(a + i), value));
    else if (in.immediate == Instruction::Immediate::first)
      for (int i = 0; i < chunk_.count; i += lanes) store(to + i, f(value, load<Pack>(b + i)));
    else
      for (int i = 0; i < chunk_.count; i += lanes) store(to + i, f(load<Pack>(a + i), load<Pack>(b + i)));
  }
  // Of a product and a third operand.
  template <class Function>
  ISOSTRETCH_INLINE void fused(const Instruction& in, const Function& f) const {
    const double *a = at(in.a), *b = at(in.b), *c = at(in.c);
    double* to = at(in.to);
    const Pack value(in.value);
    if (in.immediate == Instruction::Immediate::second)
      for (int i = 0; i < chunk_.count; i += lanes)
        store(to + i, f(load<Pack>(a + i), value, load<Pack>(c + i)));
    else if (in.immediate == Instruction::Immediate::third)
      for (int i = 0; i < chunk_.count; i += lanes)
        store(to + i, f(load<Pack>(a + i), load<Pack>(b + i), value));
    else
      for (int i = 0; i < chunk_.count; i += lanes)
        store(to + i, f(load<Pack>(a + i), load<Pack>(b + i), load<Pack>(c + i)));
  }
  // Functions that no pack has.
  template <class Function>
  ISOSTRETCH_INLINE void one_by_one(const Instruction& in, const Function& f) const {
    const double* a = at(in.a);
    double* to = at(in.to);
    for (int i = 0; i < chunk_.count; ++i) to[i] = f(a[i]);
  }

  template <int Dim>
  void variable(const Instruction& in) const {
    double* to = at(in.to);
    const int number = static_cast<int>(in.value), axis = number - static_cast<int>(Variable::s1);
    for (int i = 0; i < chunk_.count; i += lanes) {
      const auto s = load_stretch<Dim>(chunk_, i);
      Pack value = number == 0 ? s.I1() : number == 1 ? s.I2() : s.J();
      if (axis >= 0) value = load<Pack>(chunk_.sigma + static_cast<std::size_t>(axis) * chunk_.stride + i);
      store(to + i, value);
    }
  }

  template <int Dim>
  void excess(const Instruction& in) const {
    double* to = at(in.to);
    const int number = static_cast<int>(in.value), axis = number - static_cast<int>(Variable::s1);
    for (int i = 0; i < chunk_.count; i += lanes) {
      const auto s = load_stretch<Dim>(chunk_, i);
      Pack value = number == 0 ? s.I1_minus_dim() : number == 1 ? s.I2_minus_dim() : s.J_minus_one();
      if (axis >= 0)
        value = load<Pack>(chunk_.sigma + static_cast<std::size_t>(axis) * chunk_.stride + i) - Pack(1.0);
      store(to + i, value);
    }
  }

  template <int Dim>
  void step(const Instruction& in) const {
    const Pack zero(0.0), one(1.0);
    switch (in.op) {
      case Op::constant: {
        double* to = at(in.to);
        for (int i = 0; i < chunk_.count; i += lanes) store(to + i, Pack(in.value));
        break;
      }
      case Op::variable:
        return variable<Dim>(in);
      case Op::excess:
        return excess<Dim>(in);
      case Op::add:
        return binary(in, [](Pack a, Pack b) { return a + b; });
      case Op::subtract:
        return binary(in, [](Pack a, Pack b) { return a - b; });
      case Op::multiply:
        return binary(in, [](Pack a, Pack b) { return a * b; });
      case Op::divide:
        return binary(in, [](Pack a, Pack b) { return a / b; });
      case Op::multiply_add:
        return fused(in, [](Pack a, Pack b, Pack c) { return fma(a, b, c); });
      case Op::multiply_subtract:
        return fused(in, [](Pack a, Pack b, Pack c) { return fma(a, b, -c); });
      case Op::subtract_product:
        return fused(in, [](Pack a, Pack b, Pack c) { return fma(-a, b, c); });
      case Op::negate:
        return unary(in, [](Pack a) { return -a; });
      case Op::power:
        return unary(in, [&](Pack a) { return pow(a, Pack(in.value)); });
      case Op::sqrt:
        return unary(in, [](Pack a) { return sqrt(a); });
      case Op::cbrt:
        return unary(in, [](Pack a) { return cbrt(a); });
      case Op::exp:
        return unary(in, [](Pack a) { return exp(a); });
      case Op::expm1:
        return unary(in, [](Pack a) { return expm1(a); });
      case Op::log:
        return unary(in, [](Pack a) { return log(a); });
      case Op::log1p:
        return unary(in, [](Pack a) { return log1p(a); });
      case Op::sin:
        return one_by_one(in, [](double a) { return __builtin_sin(a); });
      case Op::cos:
        return one_by_one(in, [](double a) { return __builtin_cos(a); });
      case Op::tan:
        return one_by_one(in, [](double a) { return __builtin_tan(a); });
      case Op::sinh:
        return one_by_one(in, [](double a) { return __builtin_sinh(a); });
      case Op::cosh:
        return one_by_one(in, [](double a) { return __builtin_cosh(a); });
      case Op::tanh:
        return one_by_one(in, [](double a) { return __builtin_tanh(a); });
      case Op::atan:
        return one_by_one(in, [](double a) { return __builtin_atan(a); });
      case Op::abs:
        return unary(in, [](Pack a) { return abs(a); });
      case Op::sign:
        return unary(in, [&](Pack a) { return select(zero < a, one, select(a < zero, -one, a)); });
      case Op::min:
        return binary(in, [](Pack a, Pack b) { return select(a < b, a, select(b <= a, b, a + b)); });
      case Op::max:
        return binary(in, [](Pack a, Pack b) { return select(b < a, a, select(a <= b, b, a + b)); });
      case Op::expm1_ratio:
        return unary(in,
                     [&](Pack a) { return select(a == zero, one, expm1(a) / select(a == zero, one, a)); });
      case Op::log1p_ratio:
        return unary(in,
                     [&](Pack a) { return select(a == zero, one, log1p(a) / select(a == zero, one, a)); });
      case Op::less:
        return binary(in, [&](Pack a, Pack b) { return select(a < b, one, zero); });
      case Op::less_equal:
        return binary(in, [&](Pack a, Pack b) { return select(a <= b, one, zero); });
      case Op::logical_and:
        return binary(in,
                      [&](Pack a, Pack b) { return select(a == zero, zero, select(b == zero, zero, one)); });
      case Op::logical_or:
        return binary(in,
                      [&](Pack a, Pack b) { return select(a == zero, select(b == zero, zero, one), one); });
      case Op::logical_not:
        return unary(in, [&](Pack a) { return select(a == zero, one, zero); });
      case Op::select: {
        const double *a = at(in.a), *b = at(in.b), *c = at(in.c);
        double* to = at(in.to);
        for (int i = 0; i < chunk_.count; i += lanes)
          store(to + i, select(load<Pack>(a + i) == zero, load<Pack>(c + i), load<Pack>(b + i)));
        break;
      }
    }
  }

  const Task& task_;
  const energies::StretchChunk& chunk_;
};

ISOSTRETCH_INLINE Pack result(const Task& task, const energies::StretchChunk& chunk, int number, int i) {
  return load<Pack>(task.registers + static_cast<std::size_t>(task.results[number]) * chunk.stride + i);
}

// What is not finite, and all beyond the bound, is outside of the domain.
template <int Dim>
ISOSTRETCH_INLINE Pack guarded(const Task& task, const PrincipalStretches<Dim, Pack>& s, Pack psi) {
  const Pack infinity(__builtin_inf());
  return select(Pack(task.determinant_bound) < s.J(), select(abs(psi) < infinity, psi, infinity), infinity);
}

template <int Dim>
void psi_of(const Task& task, const energies::StretchChunk& chunk) {
  Machine(task, chunk).run<Dim>();
  for (int i = 0; i < chunk.count; i += lanes)
    store(chunk.psi + i, guarded(task, load_stretch<Dim>(chunk, i), result(task, chunk, 0, i)));
}

template <int Dim>
void from_partials(const Task& task, const energies::StretchChunk& chunk) {
  Machine(task, chunk).run<Dim>();
  for (int i = 0; i < chunk.count; i += lanes) {
    const auto s = load_stretch<Dim>(chunk, i);
    const auto partial = [&](int number) { return result(task, chunk, number, i); };
    Partials<Pack> p(partial(0));
    p.P1 = partial(1), p.P2 = partial(2), p.P3 = partial(3);
    p.P11 = partial(4), p.P22 = partial(5), p.P33 = partial(6);
    p.P12 = partial(7), p.P23 = partial(8), p.P13 = partial(9);
    StretchDerivatives<Dim, Pack> d;
    derivatives_from_partials(s, p, d);
    store(chunk.psi + i, guarded(task, s, d.psi));
    store_derivatives(chunk, i, d);
  }
}

template <int Dim>
void from_stretches(const Task& task, const energies::StretchChunk& chunk) {
  Machine(task, chunk).run<Dim>();
  constexpr int pairs = invariants::pair_count<Dim>;
  for (int i = 0; i < chunk.count; i += lanes) {
    const auto s = load_stretch<Dim>(chunk, i);
    const auto next = [&](int number) { return result(task, chunk, number, i); };
    StretchDerivatives<Dim, Pack> d;
    for (int e = 0; e < Dim; ++e) {
      d.gradient[e] = next(1 + e);
      d.diagonal[e] = next(1 + Dim + e);
    }
    for (int e = 0; e < pairs; ++e) {
      const Pack slopes = d.gradient[invariants::first<Dim>(e)] + d.gradient[invariants::second<Dim>(e)];
      d.twist[e] = slopes / s.safe_sum(e);
      d.coupling[e] = next(1 + 2 * Dim + e);
      d.flip[e] = next(1 + 2 * Dim + pairs + e);
    }
    store(chunk.psi + i, guarded(task, s, next(0)));
    store_derivatives(chunk, i, d);
  }
}

}  // namespace

extern const ExpressionKernels expression_kernels;
const ExpressionKernels expression_kernels = {
    {psi_of<2>, psi_of<3>}, {from_partials<2>, from_partials<3>}, {from_stretches<2>, from_stretches<3>}};

}  // namespace isostretch::expressions::ISOSTRETCH_KERNELS
