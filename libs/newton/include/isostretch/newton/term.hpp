#pragma once

#include <isostretch/assembly/energy_assembler.hpp>
#include <isostretch/assembly/hessian_pattern.hpp>
#include <isostretch/core/vector.hpp>
#include <isostretch/projection/filter.hpp>

#include <utility>
#include <vector>

namespace isostretch::newton {

using assembly::Evaluation;

/// One summand of an objective over node positions x, a vector of dim * node_count entries, node by node.
/// Virtual once per call; all loops are inside.
class Term {
 public:
  virtual ~Term();

  /// Throws Error unless the term is one of positions of so many nodes in this dimension. An objective asks
  /// when the term is added to it. Everything fits unless overridden.
  virtual void require_fits(int dim, int node_count) const;

  /// Is told that a solve begins at x, before anything is evaluated there: for state that lasts for a solve,
  /// such as friction that lags behind. Does nothing unless overridden.
  virtual void begin_solve(const Vector& x);
  /// Is told that a step has led to x, which lies in the domain and has a lower energy, before anything is
  /// differentiated there: for state that follows the iterates. What the term is worth must not change by it
  /// during the solve. Does nothing unless overridden.
  virtual void accepted(const Vector& x);

  /// Adds the pairs of nodes that the Hessian couples; every node is coupled to itself.
  virtual void add_stencil(assembly::PatternBuilder& builder) const = 0;
  /// Takes the pattern that has all its pairs, for the add_hessian() calls that follow. The pattern outlives
  /// them. A term whose stencil moves gets a new one after every move.
  virtual void set_pattern(const assembly::HessianPattern& pattern) = 0;

  /// Returns whether the pairs of add_stencil() may change while the term is part of an objective, as those
  /// of contact do; always the same answer, false unless overridden. Such a term may change them in
  /// begin_solve() and in accepted(), and between solves. The pairs of all such terms should be few beside
  /// the others: after a change they are sorted, while what stays is only merged with them.
  virtual bool has_moving_stencil() const;
  /// Returns a number that is another one whenever add_stencil() has changed. 0 unless overridden.
  virtual int stencil_version() const;

  /// Returns the value at x, +infinity outside the domain.
  virtual Evaluation value(const Vector& x) = 0;
  /// Returns whether change() is more exact than a difference of values. False unless overridden.
  virtual bool has_exact_change() const;
  /// Returns value(x + t dx) - value(x) without subtracting values, so that steps that change the value by
  /// less than its last digit can be told apart; +infinity where x + t dx lies outside the domain. The line
  /// search asks where has_exact_change(). The difference of values unless overridden.
  virtual double change(const Vector& x, const Vector& dx, double t);
  /// Adds to the gradient; with hessian, prepares add_hessian(). Where the value is infinite nothing is
  /// added.
  virtual Evaluation differentiate(const Vector& x, const projection::FilterOptions& filter, Vector& gradient,
                                   bool hessian) = 0;
  /// Adds the Hessian of the last differentiate() to matrix values with the bound pattern.
  virtual void add_hessian(double* values) const = 0;
  /// Returns an element to whose gradient or Hessian in the last differentiate() infinity or NaN can be
  /// traced; -1, as unless overridden, if there is none.
  virtual int element_not_finite() const;

  /// Returns the largest t <= limit for which x + s dx is in the domain for all 0 <= s < t; the limit unless
  /// overridden.
  virtual double max_step(const Vector& x, const Vector& dx, double limit) const;
  /// Returns whether the value grows beyond all bounds towards the edge of the domain. False unless
  /// overridden.
  virtual bool has_barrier() const;
};

/// scale * sum over quadrature points of weight * psi(F).
class EnergyTerm final : public Term {
 public:
  /// Makes the term of these elements, which must outlive it, with an energy.
  EnergyTerm(const assembly::Elements& elements, energies::AnyEnergy energy);

  /// Multiplies the energy by a number of 0 or more, 1 at first. A term of scale 0 is left out, with its
  /// domain. Throws Error when negative or not finite.
  void set_scale(double scale);
  /// Takes another energy from the next solve on; pattern and analysis of a Solver stay. Throws Error when it
  /// does not exist in the dimension of the elements.
  void set_energy(energies::AnyEnergy energy) { assembler_.set_energy(std::move(energy)); }

  void require_fits(int dim, int node_count) const override;
  void add_stencil(assembly::PatternBuilder& builder) const override;
  void set_pattern(const assembly::HessianPattern& pattern) override;
  Evaluation value(const Vector& x) override;
  Evaluation differentiate(const Vector& x, const projection::FilterOptions& filter, Vector& gradient,
                           bool hessian) override;
  void add_hessian(double* values) const override;
  int element_not_finite() const override;
  double max_step(const Vector& x, const Vector& dx, double limit) const override;
  bool has_barrier() const override { return !left_out_ && assembler_.energy().has_barrier(); }

  /// Returns the assembler behind the term.
  const assembly::EnergyAssembler& assembler() const { return assembler_; }

 private:
  assembly::EnergyAssembler assembler_;
  bool left_out_ = false;
};

/// Throws Error naming the term unless `dim` and `node_count`, its own, go with an objective's.
void require_fitting(const char* term, int dim, int node_count, int objective_dim, int objective_node_count);

/// A node and where it is drawn to.
struct SoftPin {
  /// The node that is pulled.
  int node = -1;
  std::vector<double> target;  ///< dim entries
  double weight = 1;           ///< energy per squared length
};

/// sum over pins of weight |x_node - target|^2.
class SoftPinTerm final : public Term {
 public:
  /// Throws Error naming the pin when its node is out of range, its target has the wrong size or is not
  /// finite, or its weight is not positive.
  SoftPinTerm(int dim, int node_count, std::vector<SoftPin> pins);

  void require_fits(int dim, int node_count) const override;
  void add_stencil(assembly::PatternBuilder& builder) const override;
  void set_pattern(const assembly::HessianPattern& pattern) override;
  Evaluation value(const Vector& x) override;
  Evaluation differentiate(const Vector& x, const projection::FilterOptions& filter, Vector& gradient,
                           bool hessian) override;
  void add_hessian(double* values) const override;

 private:
  int dim_;
  int node_count_;
  std::vector<SoftPin> pins_;
  const assembly::HessianPattern* pattern_ = nullptr;
};

}  // namespace isostretch::newton
