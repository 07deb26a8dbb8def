#pragma once

#include "first_order_driver.hpp"

#include <deque>

namespace isostretch::baselines {

// The last few steps s and what the gradient changed by, z, as the inverse of a matrix B that is H but has
// B s = z: the two loops of limited-memory BFGS (Nocedal 1980), about the metric as it is, not scaled.
class SecantHistory {
 public:
  // Pairs with z . s <= 0 are left out: they would make B indefinite.
  void add(Vector s, Vector z);
  bool empty() const { return pairs_.empty(); }
  void clear() { pairs_.clear(); }

  // -B^-1 gradient.
  void direction(const Vector& gradient, SharedPieces& pieces, Vector& direction) const;

 private:
  struct Pair {
    Vector s, z;
    double curvature;  // z . s
  };
  // What Liu, Bouaziz, Kavan 2017 and Zhu, Bridson, Kaufman 2018 have about a Laplacian.
  static constexpr std::size_t length = 5;

  std::deque<Pair> pairs_;  // newest last
};

// Line search along -B^-1 gradient, with hooks for what is done with pairs and directions.
class QuasiNewton : public FirstOrderMethod {
 public:
  explicit QuasiNewton(const newton::Options& search) : search_(search) {}
  Step step(const Iterate& at, SharedPieces& pieces) final;
  bool restart() final;

 private:
  // In the place of y, the change of the gradient along s.
  virtual Vector secant(const Vector& s, Vector y, SharedPieces& pieces);
  // Changes the direction at the iterate x; what does not descend any more is not taken.
  virtual void correct(const Vector& x, Vector& direction, SharedPieces& pieces);

  newton::Options search_;
  SecantHistory history_;
  Vector last_x_, last_gradient_;  // empty: none
};

}  // namespace isostretch::baselines
