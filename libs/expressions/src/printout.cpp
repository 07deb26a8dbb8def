
#include "derivatives.hpp"
#include "parser.hpp"
#include "printing.hpp"

#include <isostretch/core/error.hpp>
#include <isostretch/expressions/expression.hpp>
#include <isostretch/expressions/printout.hpp>

#include <optional>

namespace isostretch::expressions {
namespace {

// A pair (j, k) of stretches and the other one, i, which in the plane is 1.
class Derivation {
 public:
  Derivation(Graph& graph, std::vector<std::string> parameters, int dim)
      : g_(graph), dim_(dim), print_(graph, std::move(parameters)) {}

  std::vector<Formula> of_invariants(Node psi) {
    static const char* const names[] = {"",         "psi_I1", "psi_I2",   "psi_J",   "psi_I1I1",
                                        "psi_I2I2", "psi_JJ", "psi_I1I2", "psi_I2J", "psi_I1J"};
    const std::vector<Node> P = partials(g_, psi, dim_);
    for (std::size_t i = 1; i < P.size(); ++i) put(names[i], {P[i]});
    // FORMULAS of Smith, de Goes, Kim 2019, section 4.
    const Node flips = g_.scale(2, P[2]), volume = g_.multiply(other(), P[3]);
    put_mode("twist", {g_.add(g_.divide(g_.scale(2, P[1]), pair_sum()), g_.add(flips, volume))});
    put_mode("flip", {g_.subtract(flips, volume)});
    const Node by_product = dim_ == 2 ? s(2) : g_.multiply(s(2), s(3)), by_quotient = g_.divide(J(), s(1));
    put("A_11", {diagonal(P, by_product), diagonal(P, by_quotient)});
    put("A_12", {coupling(P)});
    return std::move(formulas_);
  }

  std::vector<Formula> of_stretches(Node psi) {
    Derivatives D(g_, dim_, Derivatives::Invariants::of_stretches);
    const int j = dim_ == 2 ? 0 : 1, k = j + 1;
    const Node by_j = D(psi, stretch(j)), by_k = D(psi, stretch(k)), by_1 = D(psi, stretch(0));
    put("psi_1", {by_1});
    put_mode("twist", {g_.divide(g_.add(by_j, by_k), pair_sum())});
    put_mode("flip", {ExchangeDifferences(g_, j, k)(by_j),
                      g_.divide(g_.subtract(by_j, by_k),
                                g_.subtract(g_.variable(stretch(j)), g_.variable(stretch(k))))});
    put("A_11", {D(by_1, stretch(0))});
    put("A_12", {D(by_1, stretch(1))});
    return std::move(formulas_);
  }

 private:
  // The first of equal ones, unless another is shorter by a quarter.
  void put(std::string name, const std::vector<Node>& equal) {
    std::string chosen;
    for (const Node node : equal)
      if (const auto text = print_(node); text && (chosen.empty() || 4 * text->size() < 3 * chosen.size()))
        chosen = *text;
    formulas_.push_back({std::move(name), std::move(chosen)});
  }
  void put_mode(const std::string& name, const std::vector<Node>& equal) {
    put(dim_ == 2 ? name : name + "_1", equal);
  }

  Node s(int number) { return g_.variable(stretch(number - 1)); }
  Node J() { return g_.variable(Variable::I3); }
  Node other() { return dim_ == 2 ? g_.constant(1) : s(1); }
  Node pair_sum() { return dim_ == 2 ? g_.variable(Variable::I1) : g_.add(s(2), s(3)); }

  // `slope`: of J by s1, the product of the others.
  Node diagonal(const std::vector<Node>& P, Node slope) {
    const Node s1 = s(1);
    Node sum = g_.add(g_.scale(2, P[2]), P[4]);
    sum = g_.add(sum, g_.multiply(g_.scale(4, g_.multiply(s1, s1)), P[5]));
    sum = g_.add(sum, g_.multiply(g_.multiply(slope, slope), P[6]));
    sum = g_.add(sum, g_.multiply(g_.scale(4, s1), P[7]));
    sum = g_.add(sum, g_.multiply(g_.scale(4, J()), P[8]));
    return g_.add(sum, g_.multiply(g_.scale(2, slope), P[9]));
  }

  // Between s1 and s2; s3 times the product of these is J.
  Node coupling(const std::vector<Node>& P) {
    const Node last = dim_ == 2 ? g_.constant(1) : s(3);
    const Node linear = dim_ == 2 ? g_.variable(Variable::I1) : g_.add(s(1), s(2));
    const Node squares =
        dim_ == 2 ? g_.variable(Variable::I2) : g_.add(g_.multiply(s(1), s(1)), g_.multiply(s(2), s(2)));
    const Node product = dim_ == 2 ? J() : g_.multiply(s(1), s(2));
    Node sum = g_.add(g_.multiply(last, P[3]), P[4]);
    sum = g_.add(sum, g_.multiply(g_.scale(4, product), P[5]));
    sum = g_.add(sum, g_.multiply(g_.multiply(last, J()), P[6]));
    sum = g_.add(sum, g_.multiply(g_.scale(2, linear), P[7]));
    sum = g_.add(sum, g_.multiply(g_.scale(2, g_.multiply(last, squares)), P[8]));
    return g_.add(sum, g_.multiply(g_.multiply(last, linear), P[9]));
  }

  Graph& g_;
  int dim_;
  Printer print_;
  std::vector<Formula> formulas_;
};

}  // namespace

std::vector<Formula> print_derivatives(std::string_view text, int dim) {
  const std::set<std::string> names = parameter_names(text);
  Graph graph;
  Mentions mentions;
  const Node psi = parse_with_names(text, dim, names, graph, mentions);
  if (!mentions.exist_in(dim))
    throw Error("the expression does not exist in " + std::to_string(dim) + "D: " + std::string(text));
  graph.assume_finite();
  Derivation derivation(graph, {names.begin(), names.end()}, dim);
  return mentions.only_invariants() ? derivation.of_invariants(psi) : derivation.of_stretches(psi);
}

}  // namespace isostretch::expressions
