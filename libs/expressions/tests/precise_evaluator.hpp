#pragma once

// Expressions once more, written apart from the library and evaluated as they are read, in long double.
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <map>
#include <string>

namespace isostretch::tests {

class PreciseEvaluator {
 public:
  PreciseEvaluator(const std::string& text, const std::map<std::string, long double>& names)
      : p_(text.c_str()), names_(names) {}
  long double run() { return ternary(); }

 private:
  using Real = long double;

  char peek() {
    while (*p_ == ' ') ++p_;
    return *p_;
  }
  bool eat(const char* token) {
    peek();
    const std::string wanted(token);
    if (std::string(p_).rfind(wanted, 0) != 0) return false;
    p_ += wanted.size();
    return true;
  }

  Real ternary() {
    const Real condition = disjunction();
    if (!eat("?")) return condition;
    const Real a = ternary();
    eat(":");
    const Real b = ternary();
    return condition != 0 ? a : b;
  }
  Real disjunction() {
    Real a = conjunction();
    while (eat("||")) {
      const Real b = conjunction();
      a = a != 0 || b != 0;
    }
    return a;
  }
  Real conjunction() {
    Real a = comparison();
    while (eat("&&")) {
      const Real b = comparison();
      a = a != 0 && b != 0;
    }
    return a;
  }
  Real comparison() {
    const Real a = sum();
    if (eat("<=")) return a <= sum();
    if (eat(">=")) return a >= sum();
    if (eat("<")) return a < sum();
    if (eat(">")) return a > sum();
    return a;
  }
  Real sum() {
    Real a = product();
    for (;;) {
      if (eat("+"))
        a += product();
      else if (eat("-"))
        a -= product();
      else
        return a;
    }
  }
  Real product() {
    Real a = power();
    for (;;) {
      if (eat("*"))
        a *= power();
      else if (eat("/"))
        a /= power();
      else
        return a;
    }
  }
  Real power() {
    if (eat("-")) return -power();
    if (eat("+")) return power();
    if (eat("!")) return power() == 0;
    const Real base = atom();
    return eat("^") ? std::pow(base, power()) : base;
  }
  Real atom() {
    if (eat("(")) {
      const Real inner = ternary();
      eat(")");
      return inner;
    }
    if (std::isdigit(static_cast<unsigned char>(peek())) || *p_ == '.') {
      char* end = nullptr;
      const Real number = std::strtod(p_, &end);  // what double makes of it
      p_ = end;
      return number;
    }
    std::string name;
    while (std::isalnum(static_cast<unsigned char>(*p_)) || *p_ == '_') name += *p_++;
    return eat("(") ? call(name) : names_.at(name);
  }
  Real call(const std::string& name) {
    Real arguments[3] = {ternary(), 0, 0};
    for (int i = 1; eat(","); ++i) arguments[i] = ternary();
    eat(")");
    const auto [a, b, c] = arguments;
    if (name == "if") return a != 0 ? b : c;
    if (name == "pow") return std::pow(a, b);
    if ((name == "min" || name == "max") && (std::isnan(a) || std::isnan(b))) return NAN;
    if (name == "min") return a < b ? a : b;
    if (name == "max") return a > b ? a : b;
    if (name == "sqrt") return std::sqrt(a);
    if (name == "cbrt") return std::cbrt(a);
    if (name == "exp") return std::exp(a);
    if (name == "expm1") return std::expm1(a);
    if (name == "log") return std::log(a);
    if (name == "log1p") return std::log1p(a);
    if (name == "sin") return std::sin(a);
    if (name == "cos") return std::cos(a);
    if (name == "tan") return std::tan(a);
    if (name == "sinh") return std::sinh(a);
    if (name == "cosh") return std::cosh(a);
    if (name == "tanh") return std::tanh(a);
    if (name == "atan") return std::atan(a);
    if (name == "abs") return std::abs(a);
    return NAN;
  }

  const char* p_;
  const std::map<std::string, Real>& names_;
};

}  // namespace isostretch::tests
