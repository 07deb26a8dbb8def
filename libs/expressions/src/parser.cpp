#include "parser.hpp"

#include <isostretch/expressions/expression.hpp>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <iterator>
#include <numbers>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

namespace isostretch::expressions {
namespace {

struct Function {
  std::string_view name;
  Op op;
};
constexpr Function functions[] = {
    {"sqrt", Op::sqrt},   {"cbrt", Op::cbrt}, {"exp", Op::exp},   {"expm1", Op::expm1}, {"log", Op::log},
    {"log1p", Op::log1p}, {"sin", Op::sin},   {"cos", Op::cos},   {"tan", Op::tan},     {"sinh", Op::sinh},
    {"cosh", Op::cosh},   {"tanh", Op::tanh}, {"atan", Op::atan}, {"abs", Op::abs}};

std::optional<Op> function_named(std::string_view name) {
  for (const Function& function : functions)
    if (function.name == name) return function.op;
  return std::nullopt;
}

constexpr std::string_view variables[] = {"pi", "e", "d", "s", "I1", "I2", "I3", "J", "s1", "s2", "s3"};

bool is_digit(char c) {
  return std::isdigit(static_cast<unsigned char>(c)) != 0;
}
bool begins_name(char c) {
  return std::isalpha(static_cast<unsigned char>(c)) != 0 || c == '_';
}
bool continues_name(char c) {
  return begins_name(c) || is_digit(c);
}

// Numbers and conditions are different things.
struct Value {
  Node node = 0;
  bool is_condition = false;
};

class Parser {
 public:
  enum class Parameters { by_value, by_number };

  Parser(std::string_view text, int dim, const std::map<std::string, double>& parameters, Parameters kind,
         Graph& graph, Mentions& mentions)
      : text_(text), dim_(dim), parameters_(parameters), kind_(kind), graph_(graph), mentions_(mentions) {}

  Node run() {
    if (text_.size() > max_length)
      throw Error("an expression of " + std::to_string(text_.size()) + " characters; " +
                  std::to_string(max_length) + " is the most");
    const Node result = number();
    skip_space();
    if (at_ < text_.size()) fail("there is something left over here", at_);
    return result;
  }

 private:
  // Recursion is bounded: each level of a text opens one of these.
  class Level {
   public:
    explicit Level(Parser& parser) : parser_(parser) {
      if (++parser_.depth_ > max_depth)
        parser_.fail("nested deeper than " + std::to_string(max_depth) + " levels", parser_.at_);
    }
    ~Level() { --parser_.depth_; }
    Level(const Level&) = delete;
    Level& operator=(const Level&) = delete;

   private:
    Parser& parser_;
  };

  [[noreturn]] void fail(const std::string& what, std::size_t position) const {
    throw ExpressionError(what, text_, position);
  }

  void skip_space() {
    while (at_ < text_.size() && (text_[at_] == ' ' || text_[at_] == '\t' || text_[at_] == '\n')) ++at_;
  }
  bool take(std::string_view token) {
    skip_space();
    if (text_.substr(at_, token.size()) != token) return false;
    at_ += token.size();
    return true;
  }
  void expect(std::string_view token, const char* where) {
    if (!take(token)) fail("'" + std::string(token) + "' is missing " + where, at_);
  }

  // A number, from any expression.
  Node number() {
    skip_space();
    const std::size_t start = at_;
    const Value value = conditional();
    if (value.is_condition) fail("a number is wanted here, and this is a condition", start);
    return value.node;
  }

  Value conditional() {
    skip_space();
    const std::size_t start = at_;
    const Value condition = either();
    if (!take("?")) return condition;
    if (!condition.is_condition) fail("a condition is wanted before '?'", start);
    const Node a = number();
    expect(":", "after '?' and a value");
    return {graph_.select(condition.node, a, number()), false};
  }

  Value either() {
    return joined("||", Op::logical_or, [this] { return both(); });
  }
  Value both() {
    return joined("&&", Op::logical_and, [this] { return comparison(); });
  }

  template <class Operand>
  Value joined(std::string_view token, Op op, const Operand& operand) {
    skip_space();
    const std::size_t start = at_;
    Value left = operand();
    while (take(token)) {
      skip_space();
      const std::size_t second = at_;
      const Value right = operand();
      if (!left.is_condition) fail("a condition is wanted here, and this is a number", start);
      if (!right.is_condition) fail("a condition is wanted here, and this is a number", second);
      left.node = graph_.binary(op, left.node, right.node);
    }
    return left;
  }

  Value comparison() {
    skip_space();
    const std::size_t start = at_;
    const Value left = sum_of_terms();
    for (const auto& [token, op, swapped] :
         {std::tuple{"<=", Op::less_equal, false}, std::tuple{">=", Op::less_equal, true},
          std::tuple{"<", Op::less, false}, std::tuple{">", Op::less, true}})
      if (take(token)) {
        skip_space();
        const std::size_t second = at_;
        const Value right = sum_of_terms();
        const Node a = require_number(left, start), b = require_number(right, second);
        return {swapped ? graph_.binary(op, b, a) : graph_.binary(op, a, b), true};
      }
    return left;
  }

  Node require_number(const Value& value, std::size_t position) const {
    if (value.is_condition) fail("a number is wanted here, and this is a condition", position);
    return value.node;
  }

  Value sum_of_terms() {
    skip_space();
    std::size_t start = at_;
    Value left = product();
    for (;;) {
      const bool plus = take("+"), minus = !plus && take("-");
      if (!plus && !minus) return left;
      skip_space();
      const std::size_t second = at_;
      const Node a = require_number(left, start), b = require_number(product(), second);
      left = {plus ? graph_.add(a, b) : graph_.subtract(a, b), false};
    }
  }

  Value product() {
    skip_space();
    const std::size_t start = at_;
    Value left = signed_power();
    for (;;) {
      const bool times = take("*"), over = !times && take("/");
      if (!times && !over) return left;
      skip_space();
      const std::size_t second = at_;
      const Node a = require_number(left, start), b = require_number(signed_power(), second);
      left = {times ? graph_.multiply(a, b) : graph_.divide(a, b), false};
    }
  }

  Value signed_power() {
    const Level level(*this);
    skip_space();
    const std::size_t start = at_;
    if (take("-")) return {graph_.negate(require_number(signed_power(), start + 1)), false};
    if (take("+")) return {require_number(signed_power(), start + 1), false};
    if (take("!")) {
      const Value value = signed_power();
      if (!value.is_condition) fail("a condition is wanted after '!'", start + 1);
      return {graph_.unary(Op::logical_not, value.node), true};
    }
    const Value base = primary();
    if (!take("^")) return base;
    skip_space();
    const std::size_t second = at_;
    const Node exponent = require_number(signed_power(), second);
    return {graph_.power(require_number(base, start), exponent), false};
  }

  Value primary() {
    skip_space();
    if (at_ >= text_.size()) fail("something is missing at the end", at_);
    const char c = text_[at_];
    if (take("(")) {
      const Value inner = conditional();
      expect(")", "after '('");
      return inner;
    }
    if (is_digit(c) || c == '.') return {literal(), false};
    if (begins_name(c)) return {name(), false};
    fail("a number, a name or '(' is wanted here", at_);
  }

  Node literal() {
    double value = 0;
    const char* begin = text_.data() + at_;
    const auto [end, error] = std::from_chars(begin, text_.data() + text_.size(), value);
    if (error != std::errc() || !std::isfinite(value)) fail("this is not a number that double can hold", at_);
    at_ += static_cast<std::size_t>(end - begin);
    return graph_.constant(value);
  }

  Node name() {
    const std::size_t start = at_;
    while (at_ < text_.size() && continues_name(text_[at_])) ++at_;
    const std::string_view word = text_.substr(start, at_ - start);
    if (take("(")) return call(word, start);
    if (const auto node = known(word, start)) return *node;
    const auto parameter = parameters_.find(std::string(word));
    if (parameter == parameters_.end())
      fail("'" + std::string(word) + "' is neither a variable nor a parameter that was given", start);
    mentions_.parameters.insert(parameter->first);
    if (kind_ == Parameters::by_value) return graph_.constant(parameter->second);
    return graph_.variable(expressions::parameter(static_cast<int>(parameter->second)));
  }

  std::optional<Node> known(std::string_view word, std::size_t start) {
    if (word == "pi") return graph_.constant(std::numbers::pi);
    if (word == "e") return graph_.constant(std::numbers::e);
    if (word == "d") return graph_.constant(dim_);
    if (word == "s") {
      if (summand_ < 0) fail("'s' stands for each stretch inside of sum() only", start);
      return graph_.variable(stretch(summand_));
    }
    if (word == "I1" || word == "I2" || word == "I3" || word == "J") {
      mentions_.invariants = true;
      return graph_.variable(word == "I1" ? Variable::I1 : word == "I2" ? Variable::I2 : Variable::I3);
    }
    if (word == "s1" || word == "s2" || word == "s3") {
      mentions_.stretches = true;
      mentions_.third_stretch |= word == "s3";
      return graph_.variable(stretch(word[1] - '1'));
    }
    return std::nullopt;
  }

  Node call(std::string_view word, std::size_t start) {
    if (word == "sum") return sum_over_stretches(start);
    if (word == "if") {
      skip_space();
      const std::size_t at = at_;
      const Value condition = conditional();
      if (!condition.is_condition) fail("if() wants a condition first", at);
      expect(",", "after the condition of if()");
      const Node a = number();
      expect(",", "between the values of if()");
      const Node b = number();
      expect(")", "at the end of if()");
      return graph_.select(condition.node, a, b);
    }
    if (word == "pow" || word == "min" || word == "max") {
      const Node a = number();
      expect(",", "between the arguments");
      const Node b = number();
      expect(")", "after two arguments");
      return word == "pow" ? graph_.power(a, b) : graph_.binary(word == "min" ? Op::min : Op::max, a, b);
    }
    const auto op = function_named(word);
    if (!op) fail("there is no function '" + std::string(word) + "'", start);
    const Node a = number();
    expect(")", "after one argument");
    return graph_.unary(*op, a);
  }

  // Reads its argument once for every stretch.
  Node sum_over_stretches(std::size_t start) {
    if (summand_ >= 0) fail("sum() inside of sum()", start);
    mentions_.sum = true;
    const std::size_t argument = at_;
    Node total = graph_.constant(0);
    for (summand_ = 0; summand_ < dim_; ++summand_) {
      at_ = argument;
      total = graph_.add(total, number());
    }
    summand_ = -1;
    expect(")", "at the end of sum()");
    return total;
  }

  std::string_view text_;
  int dim_;
  const std::map<std::string, double>& parameters_;
  Parameters kind_;
  Graph& graph_;
  Mentions& mentions_;
  std::size_t at_ = 0;
  int depth_ = 0;
  int summand_ = -1;  // axis that s stands for, -1 outside of sum()
};

}  // namespace

bool is_expression(std::string_view text) {
  const bool is_name =
      !text.empty() && begins_name(text[0]) && std::all_of(text.begin(), text.end(), continues_name);
  return !is_name || std::find(std::begin(variables), std::end(variables), text) != std::end(variables);
}

std::set<std::string> parameter_names(std::string_view text) {
  std::set<std::string> names;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t start = at;
    if (is_digit(text[at]) || text[at] == '.') {
      double number = 0;
      const auto [end, error] = std::from_chars(text.data() + at, text.data() + text.size(), number);
      at = std::max(static_cast<std::size_t>(end - text.data()), start + 1);
    } else if (begins_name(text[at])) {
      while (at < text.size() && continues_name(text[at])) ++at;
      const std::string_view word = text.substr(start, at - start);
      const bool is_call =
          text.substr(std::min(text.find_first_not_of(' ', at), text.size())).starts_with('(');
      if (!is_call && std::find(std::begin(variables), std::end(variables), word) == std::end(variables))
        names.emplace(word);
    } else {
      ++at;
    }
  }
  return names;
}

Node parse(std::string_view text, int dim, const std::map<std::string, double>& parameters, Graph& graph,
           Mentions& mentions) {
  return Parser(text, dim, parameters, Parser::Parameters::by_value, graph, mentions).run();
}

Node parse_with_names(std::string_view text, int dim, const std::set<std::string>& parameters, Graph& graph,
                      Mentions& mentions) {
  std::map<std::string, double> numbers;
  for (const std::string& name : parameters) numbers.emplace(name, numbers.size());
  return Parser(text, dim, numbers, Parser::Parameters::by_number, graph, mentions).run();
}

std::string_view function_name(Op op) {
  for (const Function& function : functions)
    if (function.op == op) return function.name;
  return {};
}

}  // namespace isostretch::expressions
