#include "printing.hpp"

#include "parser.hpp"
#include "printed_number.hpp"

#include <isostretch/expressions/expression.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace isostretch::expressions {
namespace {

constexpr double rounding = 2e-15;
constexpr std::size_t most_terms = 500;

std::string joined(const std::vector<std::string>& parts, const char* between) {
  std::string text;
  for (const std::string& part : parts) text += (text.empty() ? "" : between) + part;
  return text;
}

// By append(): g++ 12 warns of a + of these without reason.
std::string in_parentheses(const std::string& text) {
  return std::string(1, '(').append(text).append(1, ')');
}

std::string with_sign(bool minus, const std::string& text) {
  return std::string(minus ? 1 : 0, '-').append(text);
}

}  // namespace

std::optional<std::string> Printer::operator()(Node node) {
  try {
    std::string result = text(simplified(node));
    if (result.size() <= max_length) return result;
  } catch (const Nothing&) {
  }
  return std::nullopt;
}

// ---- from the graph ----

Printer::Sum Printer::simplified(Node node) {
  if (const auto found = known_.find(node); found != known_.end()) return found->second;
  Sum result = converted(graph_[node]);
  if (result.size() > most_terms) throw Nothing();
  known_.emplace(node, result);
  return result;
}

Printer::Sum Printer::converted(const Operation& o) {
  switch (o.op) {
    case Op::constant:
      return number(o.value);
    case Op::variable:
      return name(static_cast<Variable>(o.value));
    case Op::add:
      return add(simplified(o.a), 1, simplified(o.b));
    case Op::subtract:
      return add(simplified(o.a), -1, simplified(o.b));
    case Op::negate:
      return add({}, -1, simplified(o.a));
    case Op::multiply:
      return multiply(simplified(o.a), simplified(o.b));
    case Op::divide:
      return multiply(simplified(o.a), power(simplified(o.b), -1));
    case Op::power:
      return power(simplified(o.a), o.value);
    case Op::sqrt:
      return power(simplified(o.a), 0.5);
    case Op::exp:
      return exponential(simplified(o.a));
    case Op::sign: {
      const std::string a = text(simplified(o.a));
      return call_of_texts("if", {a + " > 0", "1", "if(" + a + " < 0, -1, 0)"});
    }
    case Op::min:
    case Op::max:
      return call_of_texts(o.op == Op::min ? "min" : "max", {text(simplified(o.a)), text(simplified(o.b))});
    case Op::select:
      return call_of_texts("if", {condition(o.a), text(simplified(o.b)), text(simplified(o.c))});
    default:
      return call(o.op, simplified(o.a));
  }
}

Printer::Sum Printer::name(Variable variable) {
  static const char* const names[] = {"I1", "I2", "J", "s1", "s2", "s3"};
  const auto number = static_cast<std::size_t>(variable);
  if (variable <= Variable::s3) return of_atom(intern({Kind::variable, names[number], {}}));
  return of_atom(intern({Kind::parameter, parameters_[number - static_cast<std::size_t>(parameter(0))], {}}));
}

Printer::Sum Printer::number(double value) {
  if (value == 0) return {};
  if (std::isfinite(value)) return {{snapped(value), {}}};
  return of_atom(intern({Kind::sum, std::isnan(value) ? "0/0" : value > 0 ? "1/0" : "-1/0", {}}));
}

Printer::Sum Printer::call(Op op, const Sum& argument) {
  const std::string_view function = function_name(op);
  if (function.empty()) throw Nothing();
  if (argument.empty()) return number(apply({op, 0, 0, 0, 0}, 0, 0, 0));
  AtomInfo atom{Kind::call, std::string(function) + in_parentheses(text(argument)), {}};
  if (op == Op::log) {
    atom.is_logarithm = true;
    atom.content = argument;
  }
  return of_atom(intern(std::move(atom)));
}

// exp(p log(x)) is how the graph has x^p for a p that is not a number.
Printer::Sum Printer::exponential(const Sum& argument) {
  if (argument.size() == 1) {
    const Product& product = argument[0].product;
    for (std::size_t i = 0; i < product.size(); ++i) {
      const AtomInfo& atom = atoms_[product[i].base];
      if (!atom.is_logarithm || product[i].exponent != 1) continue;
      Term rest = argument[0];
      rest.product.erase(rest.product.begin() + static_cast<std::ptrdiff_t>(i));
      const Sum base = atom.content;  // a copy: atoms move
      return rest.product.empty() ? power(base, rest.factor) : symbolic_power(base, text(Sum{rest}));
    }
  }
  return call(Op::exp, argument);
}

Printer::Sum Printer::symbolic_power(const Sum& base, const std::string& exponent) {
  const bool is_name = !is_expression(exponent);
  const bool is_atom = base.size() == 1 && base[0].factor == 1 && base[0].product.size() == 1 &&
                       base[0].product[0].exponent == 1;
  const std::string below = is_atom ? base_text(base[0].product[0].base) : in_parentheses(text(base));
  return of_atom(intern({Kind::power, below + "^" + (is_name ? exponent : in_parentheses(exponent)), {}}));
}

Printer::Sum Printer::call_of_texts(const std::string& function, const std::vector<std::string>& arguments) {
  return of_atom(intern({Kind::call, function + in_parentheses(joined(arguments, ", ")), {}}));
}

std::string Printer::condition(Node node) {
  const Operation& o = graph_[node];
  switch (o.op) {
    case Op::constant:
      return o.value != 0 ? "0 < 1" : "1 < 0";
    case Op::less:
      return text(simplified(o.a)) + " < " + text(simplified(o.b));
    case Op::less_equal:
      return text(simplified(o.a)) + " <= " + text(simplified(o.b));
    case Op::logical_and:
      return in_parentheses(condition(o.a)) + " && " + in_parentheses(condition(o.b));
    case Op::logical_or:
      return in_parentheses(condition(o.a)) + " || " + in_parentheses(condition(o.b));
    case Op::logical_not:
      return std::string(1, '!').append(in_parentheses(condition(o.a)));
    default:
      throw Nothing();  // a number: only what exchanges stretches makes conditions of these
  }
}

// ---- arithmetic ----

Printer::Sum Printer::add(const Sum& a, double factor, const Sum& b) const {
  Sum all = a;
  for (const Term& term : b) all.push_back({factor * term.factor, term.product});
  return collected(std::move(all));
}

Printer::Sum Printer::collected(Sum terms) const {
  std::stable_sort(terms.begin(), terms.end(),
                   [this](const Term& a, const Term& b) { return before(a.product, b.product); });
  Sum result;
  for (Term& term : terms) {
    if (result.empty() || result.back().product != term.product) {
      result.push_back(std::move(term));
      continue;
    }
    double& factor = result.back().factor;
    const double sum = factor + term.factor;
    factor = std::abs(sum) <= rounding * std::abs(factor) ? 0 : snapped(sum);
  }
  std::erase_if(result, [](const Term& term) { return term.factor == 0; });
  return result;
}

bool Printer::is_plain(const Term& term) const {
  return std::all_of(term.product.begin(), term.product.end(),
                     [this](const Power& p) { return atoms_[p.base].kind <= Kind::variable; });
}

Printer::Sum Printer::multiply(const Sum& a, const Sum& b) {
  if (a.empty() || b.empty()) return {};
  if (a.size() == 1 && b.size() == 1) return expanded(times(a[0], b[0]));
  const auto spread = [this](const Term& over, const Sum& sum) {
    Sum all;
    for (const Term& term : sum) all.push_back(times(over, term));
    return collected(std::move(all));
  };
  if (a.size() == 1 && is_plain(a[0])) return spread(a[0], b);
  if (b.size() == 1 && is_plain(b[0])) return spread(b[0], a);
  return expanded(times(factored(a), factored(b)));
}

Printer::Term Printer::times(const Term& a, const Term& b) const {
  Term result{snapped(a.factor * b.factor), a.product};
  for (const Power& power : b.product) {
    const auto place = std::find_if(result.product.begin(), result.product.end(),
                                    [&](const Power& p) { return p.base == power.base; });
    if (place == result.product.end())
      result.product.push_back(power);
    else
      place->exponent = snapped(place->exponent + power.exponent);
  }
  std::erase_if(result.product, [](const Power& p) { return std::abs(p.exponent) < rounding; });
  std::sort(result.product.begin(), result.product.end(),
            [this](const Power& p, const Power& q) { return before(p.base, q.base); });
  return result;
}

// A sum that is left alone among names takes them in, so that its terms meet others.
Printer::Sum Printer::expanded(const Term& term) const {
  const auto is_sum = [this](const Power& p) { return atoms_[p.base].kind == Kind::sum; };
  const auto sum = std::find_if(term.product.begin(), term.product.end(), is_sum);
  if (sum == term.product.end() || sum->exponent != 1 || atoms_[sum->base].content.empty()) return {term};
  Term others{term.factor, {}};
  for (const Power& power : term.product)
    if (power.base != sum->base) others.product.push_back(power);
  if (!is_plain(others)) return {term};
  Sum all;
  for (const Term& inner : atoms_[sum->base].content) all.push_back(times(others, inner));
  return collected(std::move(all));
}

Printer::Sum Printer::power(const Sum& base, double exponent) {
  if (exponent == 0) return number(1);
  if (base.empty()) return number(exponent > 0 ? 0 : std::numeric_limits<double>::infinity());
  if (is_whole(exponent)) {
    Term term = factored(base);
    term.factor = snapped(std::pow(term.factor, exponent));
    for (Power& power : term.product) power.exponent = snapped(power.exponent * exponent);
    return expanded(term);
  }
  const Term& first = base[0];
  const bool is_atom =
      base.size() == 1 && first.factor > 0 && first.product.size() == 1 && first.product[0].exponent == 1;
  if (is_atom) return {{std::pow(first.factor, exponent), {{first.product[0].base, exponent}}}};
  return of_atom(intern({Kind::sum, text(base), base}), snapped(exponent));
}

Printer::Term Printer::common(const Sum& sum) const {
  Term result{1, {}};
  for (const Power& power : sum[0].product) {
    double least = power.exponent;
    for (const Term& term : sum) {
      const auto same = std::find_if(term.product.begin(), term.product.end(),
                                     [&](const Power& p) { return p.base == power.base; });
      const double exponent = same == term.product.end() ? 0 : same->exponent;
      least = exponent * least <= 0 ? 0 : std::abs(exponent) < std::abs(least) ? exponent : least;
    }
    if (least != 0) result.product.push_back({power.base, least});
  }
  double smallest = std::abs(sum[0].factor);
  for (const Term& term : sum) smallest = std::min(smallest, std::abs(term.factor));
  if (std::all_of(sum.begin(), sum.end(),
                  [&](const Term& term) { return is_whole(snapped(term.factor / smallest)); }))
    result.factor = smallest;
  return result;
}

Printer::Term Printer::factored(const Sum& sum, Sign sign) {
  if (sum.size() == 1) return sum[0];
  Term outside = common(sum);
  Term inverse{1 / outside.factor, outside.product};
  for (Power& power : inverse.product) power.exponent = -power.exponent;
  Sum inside;
  for (const Term& term : sum) inside.push_back(times(inverse, term));
  inside = collected(std::move(inside));
  const bool has_plus =
      std::any_of(inside.begin(), inside.end(), [](const Term& term) { return term.factor > 0; });
  if (sign == Sign::of_last ? inside.back().factor < 0 : !has_plus) {
    outside.factor = -outside.factor;
    for (Term& term : inside) term.factor = -term.factor;
  }
  const Atom atom = intern({Kind::sum, flat_text(inside), inside});
  return times(outside, {1, {{atom, 1}}});
}

// ---- order ----

Printer::Atom Printer::intern(AtomInfo atom) {
  if (atom.text.size() > max_length) throw Nothing();
  const auto [found, is_new] = index_.try_emplace({atom.kind, atom.text}, atoms_.size());
  if (is_new) atoms_.push_back(std::move(atom));
  return found->second;
}

bool Printer::before(Atom a, Atom b) const {
  const AtomInfo &x = atoms_[a], &y = atoms_[b];
  return x.kind != y.kind ? x.kind < y.kind : x.text < y.text;
}

std::size_t Printer::names_in(const Product& product) const {
  return static_cast<std::size_t>(std::count_if(product.begin(), product.end(), [this](const Power& p) {
    return atoms_[p.base].kind > Kind::parameter;
  }));
}

// Simple ones first.
bool Printer::before(const Product& a, const Product& b) const {
  if (const auto x = names_in(a), y = names_in(b); x != y) return x < y;
  return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end(),
                                      [this](const Power& p, const Power& q) {
                                        if (p.base != q.base) return before(p.base, q.base);
                                        return p.exponent > q.exponent;
                                      });
}

// ---- text ----

// With what is common to all terms in front, where that is no longer.
std::string Printer::text(const Sum& sum) {
  std::string flat = flat_text(sum);
  if (sum.size() < 2) return flat;
  const Term term = factored(sum, Sign::for_reading);
  std::string product = with_sign(term.factor < 0, text(term));
  return product.size() <= flat.size() ? product : flat;
}

// A term without a minus comes first, if there is one.
std::string Printer::flat_text(const Sum& sum) const {
  if (sum.empty()) return "0";
  const auto positive =
      std::find_if(sum.begin(), sum.end(), [](const Term& term) { return term.factor > 0; });
  const auto first = positive == sum.end() ? sum.begin() : positive;
  std::string result = with_sign(first->factor < 0, text(*first));
  for (auto term = sum.begin(); term != sum.end(); ++term) {
    if (term == first) continue;
    result += (term->factor < 0 ? " - " : " + ") + text(*term);
    if (result.size() > max_length) throw Nothing();
  }
  return result;
}

std::string Printer::text(const Term& term) const {
  const Fraction factor = readable(std::abs(term.factor));
  std::vector<std::string> above, below;
  if (factor.above != 1) above.push_back(shortest(factor.above));
  if (factor.below != 1) below.push_back(shortest(factor.below));
  for (const Power& power : term.product)
    (power.exponent > 0 ? above : below).push_back(text(Power{power.base, std::abs(power.exponent)}));
  const std::string numerator = above.empty() ? "1" : joined(above, "*");
  if (below.empty()) return numerator;
  return numerator + "/" + (below.size() == 1 ? below[0] : in_parentheses(joined(below, "*")));
}

std::string Printer::text(const Power& power) const {
  const AtomInfo& atom = atoms_[power.base];
  if (power.exponent == 1) return atom.kind == Kind::power ? atom.text : base_text(power.base);
  if (power.exponent == 0.5) return "sqrt(" + atom.text + ")";
  const Fraction exponent = readable(power.exponent);
  const std::string above = shortest(exponent.above);
  return base_text(power.base) + "^" +
         (exponent.below == 1 ? above : in_parentheses(above + "/" + shortest(exponent.below)));
}

std::string Printer::base_text(Atom atom) const {
  const AtomInfo& info = atoms_[atom];
  return info.kind < Kind::power ? info.text : in_parentheses(info.text);
}

}  // namespace isostretch::expressions
