# Doxygen reads built-in energies through this filter, which says once what the members are that energies/evaluate.hpp
# describes. Lines keep their numbers.
s|^  static constexpr const char\* name|  /** The name in the registry. */&|
s|^  static constexpr double minimum_determinant|  /** The number that det F must stay above; psi is infinite elsewhere. */&|
s|^  static constexpr bool decoupled|  /** Whether A, the Hessian of psi over the stretches, is diagonal for every F. */&|
s|^  static constexpr bool supports|  /** Returns whether the energy exists in dimension `dim`. */&|
/^  template </{
  N
  s|^.*\n.* T psi(const Invariants|  /** Returns the energy density at invariants of the stretch. */&|
  s|^.*\n.* T psi(const PrincipalStretches|  /** Returns the energy density at signed singular values. */&|
  s|^.*\n.* partials(const Invariants|  /** Returns the energy density and its derivatives over the invariants. */&|
  s|^.*\n.* derivatives(const PrincipalStretches|  /** Computes the energy density and its derivatives at signed singular values. */&|
  s|^.*\n.* parameters(Visitor|  /** Calls visit("name", member, "description") for each parameter. */&|
  s|^.*\n.* require_parameters(Require|  /** Calls require("name", condition, "must ...") for each rule of the parameters. */&|
}
