#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace isostretch::expressions {

/// A derivative of an energy as text that the parser reads, for looking at it and for using it elsewhere.
struct Formula {
  std::string name;  ///< The name, such as psi_I1, twist_1 or A_12.
  std::string text;  ///< The expression; empty where it would be longer than max_length.
};

/// Returns the expressions that decide about an energy in dimension `dim`, simplified, with its parameters by
/// name. J is I3.
///
/// For an expression in invariants these are first the partials psi_I1, psi_I2, psi_J, psi_I1I1, ..., for one
/// in stretches the slopes psi_1, ...; then for both the eigenvalues and entries of the Hessian in the frame
/// of the singular vectors: twist_1 and flip_1, of the pair (s2, s3) ("twist" and "flip" in the plane), A_11
/// and A_12. Those of other axes follow by exchanging stretches.
///
/// Simplification takes it that everything is finite, as in x / x = 1. Throws ExpressionError for a text that
/// cannot be read, and Error where the expression does not exist in that dimension.
std::vector<Formula> print_derivatives(std::string_view text, int dim);

}  // namespace isostretch::expressions
