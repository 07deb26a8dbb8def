#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace isostretch::expressions {

/// A derivative of an energy by its name, as text that the parser reads: to look at, and to take elsewhere.
struct Formula {
  std::string name;
  std::string text;  ///< empty where it would be longer than max_length
};

/// What decides about an energy in one dimension, simplified, with its parameters by name. J is I3.
///
/// Of an expression in invariants first the partials psi_I1, psi_I2, psi_J, psi_I1I1, ...; of one in
/// stretches the slopes psi_1, ...; then of both the eigenvalues and entries of the Hessian in the frame of
/// the singular vectors: twist_1 and flip_1, of the pair (s2, s3) ("twist" and "flip" in the plane), A_11 and
/// A_12. Those of other axes follow by exchanging stretches.
///
/// Simplification takes it that everything is finite, as in x / x = 1. Throws as parse_energy does for what
/// cannot be read, and Error where the expression does not exist in that dimension.
std::vector<Formula> print_derivatives(std::string_view text, int dim);

}  // namespace isostretch::expressions
