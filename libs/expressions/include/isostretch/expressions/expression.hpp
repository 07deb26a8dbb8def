#pragma once

#include <isostretch/core/error.hpp>
#include <isostretch/energies/any_energy.hpp>

#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <string_view>

namespace isostretch::expressions {

/// An Error about the text of an expression, with the place of the fault: the message ends with the text and
/// a caret under it.
class ExpressionError : public Error {
 public:
  /// Makes an error about `text`; `position` is the place of the fault, counted from 0.
  ExpressionError(const std::string& what, std::string_view text, std::size_t position);
  /// Returns the place of the fault in the text, counted from 0.
  std::size_t position() const noexcept { return position_; }

 private:
  std::size_t position_;
};

/// The greatest length of an expression, in characters.
inline constexpr std::size_t max_length = 4000;
/// The greatest depth to which parentheses, functions and operators of an expression may be nested.
inline constexpr int max_depth = 250;
/// The greatest number of operations of an expression with its derivatives.
inline constexpr std::size_t max_nodes = 20000;

/// Returns whether the text is more than a name: a formula, written where a user could have named an energy.
bool is_expression(std::string_view text);

/// Returns the names in a text that are neither variables nor functions, whether the text can be read or not.
std::set<std::string> parameter_names(std::string_view text);

/// Returns an isotropic energy from text, for every app and library that takes an AnyEnergy, such as
///
///     mu/2*(I2 - d) - mu*log(J) + lambda/2*log(J)^2
///
/// It is an expression in the invariants I1, I2, I3 (or J), or in the principal stretches s1, s2, s3; sum(f)
/// adds up f over the stretches, named s in f; d is the dimension, pi and e are numbers. There are the
/// operators `+ - * / ^` (right to left, before signs; with an exponent that is no number, exp of it times
/// the logarithm), the functions `sqrt cbrt exp expm1 log log1p pow sin cos tan sinh cosh tanh atan abs min
/// max`, and the conditions `< <= > >= && || !` in if(c, a, b) or c ? a : b. All other names are parameters,
/// whose values must be given, and nothing but arithmetic can happen.
///
/// An expression in the stretches has to be symmetric in them. What it does not mention decides where it
/// exists: s3 makes it an energy of bodies in space, s1 and s2 without it one of the plane, I1, I2, I3 and
/// sum() one of both, unless it is nowhere finite in one. Where psi is not finite at det F <= 0, or grows
/// beyond all bounds towards it, in either dimension, the energy has a barrier
/// (AnyEnergy::determinant_bound() = 0); other energies stay finite under inversion. Samples decide, not a
/// proof.
///
/// Derivatives are symbolic, in one graph that shares common subexpressions, evaluated on whole chunks at the
/// active instruction-set level. Those of invariants go the way of Smith, de Goes, Kim 2019, by the partials
/// of psi; for stretches, flips are divided differences that do not cancel where stretches are equal (of
/// powers of what is negative there, 11 digits are left).
///
/// Throws ExpressionError for a text that cannot be read and for nesting deeper than max_depth. Throws Error
/// for more than max_length characters, for more than max_nodes operations with derivatives, for parameters
/// that are missing, not finite or not in the text, and for expressions that are not symmetric or not finite
/// anywhere.
energies::AnyEnergy parse_energy(std::string_view text, const std::map<std::string, double>& parameters = {});

}  // namespace isostretch::expressions
