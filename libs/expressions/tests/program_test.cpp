// What becomes of derivatives before they run.
#include "../src/program.hpp"
#include "../src/derivatives.hpp"
#include "../src/parser.hpp"
#include "typed_builtins.hpp"

#include <isostretch/expressions/expression.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <functional>
#include <random>
#include <string>
#include <utility>
#include <vector>

using namespace isostretch;
using namespace isostretch::expressions;

namespace {

struct Parsed {
  explicit Parsed(const std::string& text) {
    Mentions mentions;
    psi = parse(text, 2, {}, graph, mentions);
  }
  Program with_derivative(Variable by) {
    graph.save_operations();
    return compile(graph, {psi, Derivatives(graph, 2, Derivatives::Invariants::independent)(psi, by)});
  }
  Graph graph;
  Node psi = 0;
};

// Without loads of variables and numbers.
std::size_t operations(const Program& program) {
  return static_cast<std::size_t>(
      std::count_if(program.code.begin(), program.code.end(), [](const Instruction& instruction) {
        return instruction.op != Op::variable && instruction.op != Op::constant;
      }));
}

std::size_t count(const Program& program, Op op) {
  return static_cast<std::size_t>(std::count_if(program.code.begin(), program.code.end(),
                                                [&](const Instruction& i) { return i.op == op; }));
}

template <int Dim>
struct Chunk {
  static constexpr int points = 64, pairs = Dim == 2 ? 1 : 3;
  std::vector<double> memory = std::vector<double>((3 * Dim + 3 * pairs + 1) * points);
  energies::StretchChunk chunk;

  explicit Chunk(const std::vector<double>& sigma) {
    double* next = memory.data();
    const auto take = [&](int arrays) { return std::exchange(next, next + arrays * points); };
    chunk.count = points;
    chunk.stride = points;
    chunk.sigma = sigma.data();
    chunk.psi = take(1);
    chunk.gradient = take(Dim);
    chunk.diagonal = take(Dim);
    chunk.twist = take(pairs);
    chunk.flip = take(pairs);
    chunk.coupling = take(pairs);
  }
};

template <int Dim>
void check_psi_beside_derivatives(const energies::AnyEnergy& energy, const std::vector<double>& sigma) {
  Chunk<Dim> alone(sigma), beside(sigma);
  energy.evaluate_psi(Dim, alone.chunk);
  energy.evaluate_derivatives(Dim, beside.chunk);
  CHECK(std::memcmp(alone.chunk.psi, beside.chunk.psi, sizeof(double) * Chunk<Dim>::points) == 0);
}

template <int Dim>
std::vector<double> random_stretches(unsigned seed) {
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> exponent(-1, 1);
  std::vector<double> sigma(Dim * Chunk<Dim>::points);
  for (int i = 0; i < Chunk<Dim>::points; ++i) {
    double s[Dim];
    for (double& value : s) value = std::exp(exponent(generator));
    std::sort(s, s + Dim, std::greater<>());
    for (int e = 0; e < Dim; ++e) sigma[static_cast<std::size_t>(e * Chunk<Dim>::points + i)] = s[e];
  }
  return sigma;
}

}  // namespace

TEST_SUITE("programs of expressions") {
  TEST_CASE("common factors leave sums, powers of a quotient need one division") {
    Parsed power("(I2/J)^4");
    CHECK(count(power.with_derivative(Variable::I2), Op::divide) == 2);  // I2 / J, and 1 / J
    CHECK(operations(power.with_derivative(Variable::I2)) <= 7);
    // 1/J^2 and its derivative -2/J^3.
    Parsed quotient("1/J^2");
    CHECK(count(quotient.with_derivative(Variable::I3), Op::divide) == 1);
    // y = I2/J again: the slope of the sum is one polynomial times dy.
    Parsed series("I2/J + 0.1*(I2/J)^2 + 0.01*(I2/J)^3 + 0.001*(I2/J)^4");
    const Program program = series.with_derivative(Variable::I3);
    CHECK(count(program, Op::multiply_add) >= 2);
    CHECK(operations(program) <= 18);
  }

  TEST_CASE("factors that would overflow together stay apart") {
    const auto energy = parse_energy("I2 + 1e200*(1e200*exp(-200*I2))");
    const auto d = energies::derivatives_at(energy, invariants::PrincipalStretches<2, double>{{1.9, 1.7}});
    CHECK(d.gradient[0] == doctest::Approx(3.8));
    CHECK(d.twist[0] == doctest::Approx(2));
  }

  TEST_CASE("powers of powers are parsed at once") {
    for (const char* text :
         {"((((((((I2/d)^16)^16)^16)^16)^16)^16)^16)^16", "sum((((((((s^16)^16)^16)^16)^16)^16)^16)^16)",
          "sum((((((s^16)^16)^16)^16)^16)^16)"}) {
      CAPTURE(text);
      CHECK(derivatives_at(parse_energy(text), invariants::PrincipalStretches<2, double>{{1, 1}}).psi > 0);
    }
    std::string nested = "s";
    for (int level = 0; level < 24; ++level) nested = "((" + nested + ")*s)^2*J";
    try {
      parse_energy("sum(" + nested + ")");
    } catch (const Error& error) {
      CHECK(std::string(error.what()).find("operations") != std::string::npos);
    }
  }

  TEST_CASE("the energies of the library do not become longer again") {
    const auto derivatives = [](const tests::TypedBuiltin& typed) {
      Graph graph;
      Mentions mentions;
      const Node psi = parse(typed.text, 2, typed.parameters, graph, mentions);
      graph.save_operations();
      return operations(compile(graph, partials(graph, psi, 2)));
    };
    for (const auto& typed : tests::typed_builtins()) {
      CAPTURE(typed.name);
      if (typed.name == "arruda_boyce") CHECK(derivatives(typed) <= 55);
      if (typed.name == "fung") CHECK(derivatives(typed) <= 32);
      if (typed.name == "neo_hookean_log") CHECK(derivatives(typed) <= 17);
    }
  }

  TEST_CASE("psi is the same to the last bit alone and beside its derivatives") {
    const auto plane = random_stretches<2>(1);
    const auto space = random_stretches<3>(2);
    for (const auto& typed : tests::typed_builtins()) {
      CAPTURE(typed.name);
      const auto energy = parse_energy(typed.text, typed.parameters);
      if (energy.supports(2)) check_psi_beside_derivatives<2>(energy, plane);
      if (energy.supports(3)) check_psi_beside_derivatives<3>(energy, space);
    }
  }

  TEST_CASE("what cancels in psi still does: the root of a discriminant at equal stretches") {
    const auto energy = parse_energy("sqrt(I1^2 - 4*J) + sqrt(I1*I1 - 4*J) + sqrt(0.3*I1^2 - 1.2*J) + I2");
    for (double s = 0.3; s < 3; s *= 1.03) {
      std::vector<double> sigma(2 * Chunk<2>::points, s);
      Chunk<2> chunk(sigma);
      energy.evaluate_psi(2, chunk.chunk);
      CHECK(chunk.chunk.psi[0] == doctest::Approx(2 * s * s).epsilon(1e-15));
    }
  }
}
