#pragma once

#include "graph.hpp"

#include <map>
#include <optional>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

namespace isostretch::expressions {

// Expressions of a graph as text, simplified on the way: every expression becomes a sum of products of powers
// of atoms, in which equal products are collected. Atoms are names, calls of functions and whole sums; what
// has the same text is the same atom. Sums are multiplied out by numbers and names alone.
class Printer {
 public:
  // `parameters`: names of those that the graph has as variables, by their number.
  Printer(const Graph& graph, std::vector<std::string> parameters)
      : graph_(graph), parameters_(std::move(parameters)) {}

  // Nothing for what is longer than max_length or has no text.
  std::optional<std::string> operator()(Node node);

 private:
  using Atom = std::size_t;
  struct Power {
    Atom base;
    double exponent;
    bool operator==(const Power&) const = default;
  };
  using Product = std::vector<Power>;  // in the order of atoms
  struct Term {
    double factor;
    Product product;
  };
  using Sum = std::vector<Term>;  // in the order of products, each once

  // From what may be repeated in a product as it stands to what needs parentheses for it.
  enum class Kind { parameter, variable, call, power, sum };
  struct AtomInfo {
    Kind kind;
    std::string text;
    Sum content;  // of a sum; of a logarithm its argument
    bool is_logarithm = false;
  };
  struct Nothing {};  // thrown

  Sum simplified(Node node);
  Sum converted(const Operation& operation);
  Sum name(Variable variable);
  Sum number(double value);
  Sum call(Op op, const Sum& argument);
  Sum exponential(const Sum& argument);
  Sum symbolic_power(const Sum& base, const std::string& exponent);
  Sum call_of_texts(const std::string& function, const std::vector<std::string>& arguments);
  std::string condition(Node node);

  Sum add(const Sum& a, double factor, const Sum& b) const;
  Sum multiply(const Sum& a, const Sum& b);
  Sum power(const Sum& base, double exponent);
  Term times(const Term& a, const Term& b) const;
  Sum expanded(const Term& term) const;
  Sum collected(Sum terms) const;
  bool is_plain(const Term& term) const;
  // What all terms have in common, and the sum as that times a sum. The sign is that of the last term, so
  // that a - b and b - a are the same but for it, or a minus only where there is nothing else.
  enum class Sign { of_last, for_reading };
  Term common(const Sum& sum) const;
  Term factored(const Sum& sum, Sign sign = Sign::of_last);

  Atom intern(AtomInfo atom);
  Sum of_atom(Atom atom, double exponent = 1) const { return {{1, {{atom, exponent}}}}; }
  bool before(Atom a, Atom b) const;
  bool before(const Product& a, const Product& b) const;
  std::size_t names_in(const Product& product) const;

  std::string text(const Sum& sum);
  std::string flat_text(const Sum& sum) const;
  std::string text(const Term& term) const;  // of its magnitude
  std::string text(const Power& power) const;
  std::string base_text(Atom atom) const;

  const Graph& graph_;
  std::vector<std::string> parameters_;
  std::vector<AtomInfo> atoms_;
  std::map<std::pair<Kind, std::string>, Atom> index_;
  std::unordered_map<Node, Sum> known_;
};

}  // namespace isostretch::expressions
