#pragma once

#include <isostretch/core/vector.hpp>
#include <isostretch/sdp_penalty/problem.hpp>

#include <iosfwd>
#include <vector>

namespace isostretch::baselines {

// The convex problem as a semidefinite program with linear matrix inequalities, which is what programs for
// these take:
//
//   minimise c^T v  such that  sum_k v_k A_k - A_0 >= 0  block by block,
//
// over v = (free entries of x, then one epigraph variable a squared term). The blocks:
//
//   S_i - margin I                                                        every element
//   [[I, sqrt(w_i) vec(F_i - R_i)], [., t_i]]                             every element
//   [[1, sqrt(kappa / 2) (tr(R_i^T F_i) - dim)], [., u_i]]                every element, if kappa > 0
//   [[b I, F_i], [., b I]]                                                every element, if b bounds stretch
//   [[I, sqrt(alpha) (x_h - target_h)], [., s_h]]                         every soft target
//
// (Schur complements: t_i >= w_i |F_i - R_i|^2 and so on), and c is 1 for every epigraph variable, 0 for x.
// Factors stand inside the blocks: as costs they spread over many orders of magnitude, and programs end
// without an answer. One epigraph a term keeps all blocks small. Hard targets are put in for their entries,
// which become part of A_0.
//
// x is in units of `length` and the epigraph variables are in units of `energy`: programs bound variables and
// optima by constants (SDPA 1e5 for the optimum, DSDP 1e7 for every variable), and judge infeasibility by
// others.
class SemidefiniteProgram {
 public:
  struct Units {
    double length = 1, energy = 1;
  };

  explicit SemidefiniteProgram(const sdp_penalty::Problem& problem) : SemidefiniteProgram(problem, Units{}) {}
  SemidefiniteProgram(const sdp_penalty::Problem& problem, const Units& units);

  /// Returns units in which coordinates are 1 and energies are 1e5 at most, as those of targets and of x
  /// tell.
  static Units units_of(const sdp_penalty::Problem& problem, const Vector& x);

  int variables() const { return variables_; }

  // In the sparse format of SDPA (Fujisawa, Kojima, Nakata, Yamashita 2002), which CSDP and DSDP read as
  // well, with all digits. Matrix 0 holds A_0, hence the negative of what is constant above.
  void write(std::ostream& out) const;

  // x from v, dim entries a node, with hard targets where they belong.
  Vector positions(const std::vector<double>& v) const;

 private:
  // Entry of the symmetric block, row <= column, counted from 0, of the matrix of one variable.
  struct Entry {
    int variable = 0;  // -1: constant
    int block = 0, row = 0, column = 0;
    double value = 0;
  };

  int add_block(int size);
  int add_epigraph_block(int rows);
  void add_term(int block, int row, int column, int dof, double factor);
  void add_constant(int block, int row, int column, double value);

  void sort_entries();
  void number_unknowns(const sdp_penalty::Problem& problem);
  void add_constraint(const sdp_penalty::Problem& problem, int element);
  void add_elastic_term(const sdp_penalty::Problem& problem, int element);
  void add_volume_term(const sdp_penalty::Problem& problem, int element);
  void add_stretch_bound(const sdp_penalty::Problem& problem, int element);
  void add_target(const sdp_penalty::Problem& problem, const sdp_penalty::Target& target);

  Units units_;
  int variables_ = 0, unknowns_ = 0;
  std::vector<int> unknown_of_dof_;  // -1: held
  std::vector<double> held_;         // the value, of what is held
  std::vector<int> block_sizes_;
  std::vector<Entry> entries_;
};

}  // namespace isostretch::baselines
