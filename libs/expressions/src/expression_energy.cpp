#include "expression_energy.hpp"

#include "derivatives.hpp"
#include "inspection.hpp"
#include "kernel_table.hpp"
#include "parser.hpp"
#include "rest_difference.hpp"

#include <isostretch/core/arena.hpp>
#include <isostretch/core/dispatch.hpp>
#include <isostretch/expressions/expression.hpp>
#include <isostretch/invariants/stretch.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

namespace isostretch::expressions {

ISOSTRETCH_DISPATCH(ExpressionKernels, expression_kernels)

namespace {

// Where two stretches are apart the plain quotient of slopes has all digits that matter. The divided
// difference would have them, too, but for functions so steep that their values there differ by powers of
// ten.
Node flip(Graph& graph, int j, int k, Node slope_j, Node slope_k) {
  constexpr double apart = 0.01;  // of a stretch
  const Node s = graph.variable(stretch(j)), gap = graph.subtract(s, graph.variable(stretch(k)));
  const Node is_apart =
      graph.binary(Op::less, graph.scale(apart, graph.unary(Op::abs, s)), graph.unary(Op::abs, gap));
  const Node quotient = graph.divide(graph.subtract(slope_j, slope_k), gap);
  return graph.select(is_apart, quotient, ExchangeDifferences(graph, j, k)(slope_j));
}

// psi, gradient, diagonal, coupling and flips, as kernels want them.
template <int Dim>
std::vector<Node> by_stretches(Graph& graph, Node psi) {
  constexpr int pairs = invariants::pair_count<Dim>;
  Derivatives D(graph, Dim, Derivatives::Invariants::of_stretches);
  std::vector<Node> outputs{psi};
  for (int i = 0; i < Dim; ++i) outputs.push_back(D(psi, stretch(i)));
  for (int i = 0; i < Dim; ++i) outputs.push_back(D(D(psi, stretch(i)), stretch(i)));
  for (int i = 0; i < pairs; ++i)
    outputs.push_back(D(D(psi, stretch(invariants::first<Dim>(i))), stretch(invariants::second<Dim>(i))));
  for (int i = 0; i < pairs; ++i) {
    const int j = invariants::first<Dim>(i), k = invariants::second<Dim>(i);
    outputs.push_back(flip(graph, j, k, D(psi, stretch(j)), D(psi, stretch(k))));
  }
  return outputs;
}

// Whether off-diagonal entries of A are anything but zero, as far as can be seen without values. Of partials
// P3 and all second ones matter.
bool couples_by_partials(const Graph& graph, const std::vector<Node>& outputs) {
  return std::any_of(outputs.begin() + 3, outputs.end(), [&](Node n) { return !graph.is_constant(n, 0); });
}
bool couples(const Graph& graph, const std::vector<Node>& outputs, int dim) {
  const int pairs = dim == 2 ? 1 : 3;
  const auto first = outputs.begin() + 1 + 2 * dim;
  return std::any_of(first, first + pairs, [&](Node n) { return !graph.is_constant(n, 0); });
}

// Registers of the calling thread, each on cache lines of its own.
double* registers(std::size_t doubles) {
  thread_local Arena memory;
  if (memory.capacity() < doubles * sizeof(double)) memory = Arena(doubles * sizeof(double));
  memory.reset();
  return memory.doubles(doubles);
}

using Kernel = void (*const (&)[2])(const Task&, const energies::StretchChunk&);

void run(const Program& program, Kernel kernel, int dim, double bound, const energies::StretchChunk& chunk) {
  double* memory = registers(static_cast<std::size_t>(program.registers) * chunk.stride);
  kernel[dim - 2]({program.code.data(), program.code.size(), memory, program.results.data(), bound}, chunk);
}

// How many points of a chunk have all stretches near 1.
enum class Near { none, some, all };

bool is_near_rest(int dim, const energies::StretchChunk& chunk, int point) {
  constexpr double near = 0.1;
  double most = 0;
  for (int e = 0; e < dim; ++e)
    most = std::max(
        most,
        std::abs(chunk.sigma[static_cast<std::size_t>(e) * chunk.stride + static_cast<std::size_t>(point)] -
                 1));
  return most <= near;
}

Near near_rest(int dim, const energies::StretchChunk& chunk) {
  int count = 0;
  for (int i = 0; i < chunk.count; ++i) count += is_near_rest(dim, chunk, i);
  return count == 0 ? Near::none : count == chunk.count ? Near::all : Near::some;
}

std::string caret(std::string_view text, std::size_t position) {
  std::string line(text);
  for (char& c : line)
    if (static_cast<unsigned char>(c) < ' ') c = ' ';
  return "\n  " + line + "\n  " + std::string(std::min(position, text.size()), ' ') + "^";
}

}  // namespace

ExpressionError::ExpressionError(const std::string& what, std::string_view text, std::size_t position)
    : Error(what + " (character " + std::to_string(position + 1) + ")" + caret(text, position)),
      position_(position) {}

ExpressionEnergy::ExpressionEnergy(std::string_view text, const std::map<std::string, double>& parameters)
    : text_(text), determinant_bound_(-std::numeric_limits<double>::infinity()) {
  for (const auto& [name, value] : parameters) {
    if (!std::isfinite(value)) throw Error("parameter '" + name + "' of an expression is not finite");
    parameters_.push_back({name, value, "of the expression"});
  }
  for (const int dim : {2, 3}) programs_[dim - 2] = programs_for(dim, parameters);
  if (!programs_[0] && !programs_[1])
    throw Error("the expression is not finite at any stretch between 1/3 and 3: " + text_);
  require_used(parameters);
  for (const auto& programs : programs_) {
    if (programs && programs->ends_at_zero) determinant_bound_ = 0;
    if (programs && programs->coupled) coupled_ = true;
  }
}

// Nothing where the expression does not exist in that dimension.
std::optional<ExpressionEnergy::Programs> ExpressionEnergy::programs_for(
    int dim, const std::map<std::string, double>& parameters) const {
  Graph graph;
  Mentions mentions;
  const Node psi = parse(text_, dim, parameters, graph, mentions);
  if (!mentions.exist_in(dim)) return std::nullopt;
  if (!finite_somewhere(graph, psi, dim)) return std::nullopt;
  if (!is_symmetric(graph, psi, dim))
    throw Error("the expression changes when stretches are exchanged, and is no isotropic energy (in " +
                std::to_string(dim) + "D): " + text_);
  Programs programs;
  programs.ends_at_zero = ends_at_zero_determinant(graph, psi, dim);
  programs.psi = compile(graph, {psi});
  programs.by_partials = mentions.only_invariants();
  graph.assume_finite();
  if (const auto near_rest = RestDifferences(graph, dim)(psi))
    programs.psi_near_rest = compile(graph, {*near_rest});
  graph.save_operations();
  const std::vector<Node> outputs = programs.by_partials ? partials(graph, psi, dim)
                                    : dim == 2           ? by_stretches<2>(graph, psi)
                                                         : by_stretches<3>(graph, psi);
  programs.coupled =
      programs.by_partials ? couples_by_partials(graph, outputs) : couples(graph, outputs, dim);
  programs.derivatives = compile(graph, outputs);
  return programs;
}

void ExpressionEnergy::require_used(const std::map<std::string, double>& parameters) const {
  Graph graph;
  Mentions mentions;
  parse(text_, 3, parameters, graph, mentions);
  for (const auto& [name, value] : parameters)
    if (!mentions.parameters.contains(name))
      throw Error("parameter '" + name + "' does not occur in the expression " + text_);
}

void ExpressionEnergy::psi(int dim, const energies::StretchChunk& chunk) const {
  const Programs& programs = *programs_[dim - 2];
  if (!programs.psi_near_rest || near_rest(dim, chunk) != Near::all)
    run(programs.psi, active_expression_kernels().psi, dim, determinant_bound_, chunk);
  replace_psi_near_rest(dim, chunk);
}

// Far from rest differences from it are no better, and logarithms of what vanishes are worse: points are
// taken one by one.
void ExpressionEnergy::replace_psi_near_rest(int dim, const energies::StretchChunk& chunk) const {
  const Programs& programs = *programs_[dim - 2];
  const Near near = programs.psi_near_rest ? near_rest(dim, chunk) : Near::none;
  if (near == Near::none) return;
  Kernel kernel = active_expression_kernels().psi;
  if (near == Near::all) return run(*programs.psi_near_rest, kernel, dim, determinant_bound_, chunk);
  thread_local std::vector<double> psi;
  psi.resize(static_cast<std::size_t>(chunk.count));
  energies::StretchChunk apart = chunk;
  apart.psi = psi.data();
  run(*programs.psi_near_rest, kernel, dim, determinant_bound_, apart);
  for (int i = 0; i < chunk.count; ++i)
    if (is_near_rest(dim, chunk, i)) chunk.psi[i] = psi[static_cast<std::size_t>(i)];
}

void ExpressionEnergy::derivatives(int dim, const energies::StretchChunk& chunk) const {
  const Programs& programs = *programs_[dim - 2];
  const ExpressionKernels& kernels = active_expression_kernels();
  run(programs.derivatives, programs.by_partials ? kernels.from_partials : kernels.from_stretches, dim,
      determinant_bound_, chunk);
  replace_psi_near_rest(dim, chunk);
}

energies::AnyEnergy parse_energy(std::string_view text, const std::map<std::string, double>& parameters) {
  return energies::AnyEnergy(std::make_shared<const ExpressionEnergy>(text, parameters));
}

}  // namespace isostretch::expressions
