// A term whose stencil moves: discs that are pulled together and push those away that they touch.
#include "expect.hpp"

#include <isostretch/newton/minimize.hpp>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

using namespace isostretch;

constexpr double diameter = 0.5, stiffness = 100;

class Discs final : public newton::Term {
 public:
  explicit Discs(int count) : count_(count) {}

  // Pairs that touch, or nearly do.
  void begin_solve(const Vector& x) override { accepted(x); }
  void accepted(const Vector& x) override {
    std::vector<std::pair<int, int>> pairs;
    for (int i = 0; i < count_; ++i)
      for (int j = 0; j < i; ++j)
        if (distance(x, i, j) < 1.2 * diameter) pairs.emplace_back(i, j);
    if (pairs == pairs_) return;
    pairs_ = std::move(pairs);
    ++version_;
  }
  bool has_moving_stencil() const override { return true; }
  int stencil_version() const override { return version_; }
  void add_stencil(assembly::PatternBuilder& builder) const override {
    for (const auto& [i, j] : pairs_) builder.add_pair(i, j);
  }
  void set_pattern(const assembly::HessianPattern& pattern) override { pattern_ = &pattern; }

  assembly::Evaluation value(const Vector& x) override {
    assembly::Evaluation at;
    at.value = 0.5 * x.squaredNorm();
    for (int i = 0; i < count_; ++i)
      for (int j = 0; j < i; ++j) {
        const double overlap = std::max(0.0, diameter - distance(x, i, j));
        at.value += 0.5 * stiffness * overlap * overlap;
      }
    return at;
  }
  assembly::Evaluation differentiate(const Vector& x, const projection::FilterOptions&, Vector& gradient,
                                     bool) override {
    gradient += x;
    normals_.assign(pairs_.size(), Eigen::Vector2d::Zero());
    for (std::size_t p = 0; p < pairs_.size(); ++p) {
      const auto [i, j] = pairs_[p];
      const double apart = distance(x, i, j);
      if (apart >= diameter) continue;
      normals_[p] = (x.segment<2>(2 * i) - x.segment<2>(2 * j)) / apart;
      const Eigen::Vector2d force = stiffness * (diameter - apart) * normals_[p];
      gradient.segment<2>(2 * i) -= force;
      gradient.segment<2>(2 * j) += force;
    }
    return value(x);
  }
  void add_hessian(double* values) const override {
    for (int i = 0; i < count_; ++i) add_block(values, i, i, Eigen::Matrix2d::Identity());
    for (std::size_t p = 0; p < pairs_.size(); ++p) {
      const auto [i, j] = pairs_[p];
      const Eigen::Matrix2d block = stiffness * normals_[p] * normals_[p].transpose();
      add_block(values, i, i, block);
      add_block(values, j, j, block);
      add_block(values, i, j, -block);
    }
  }

 private:
  static double distance(const Vector& x, int i, int j) {
    return (x.segment<2>(2 * i) - x.segment<2>(2 * j)).norm();
  }
  void add_block(double* values, int i, int j, const Eigen::Matrix2d& block) const {
    const int* positions = pattern_->positions(pattern_->block(i, j));
    for (int r = 0; r < 2; ++r)
      for (int c = 0; c < 2; ++c)
        if (positions[2 * r + c] >= 0) values[positions[2 * r + c]] += block(r, c);
  }

  int count_;
  int version_ = 0;
  std::vector<std::pair<int, int>> pairs_;  // the larger one first
  std::vector<Eigen::Vector2d> normals_;
  const assembly::HessianPattern* pattern_ = nullptr;
};

int main() {
  const int count = 12;
  newton::Objective objective(2, count);
  objective.add<Discs>(count);
  Vector x(2 * count);
  for (int i = 0; i < count; ++i)
    x.segment<2>(2 * i) = (2 + 0.3 * i) * Eigen::Vector2d(std::cos(2.4 * i), std::sin(2.4 * i));
  newton::Solver solver(objective);
  EXPECT(solver.solve(x).converged());
  EXPECT(objective.stencil_version() > 0);
  EXPECT(solver.analyses() == 1);
  double nearest = 10;
  for (int i = 0; i < count; ++i)
    for (int j = 0; j < i; ++j)
      nearest = std::min(nearest, (x.segment<2>(2 * i) - x.segment<2>(2 * j)).norm());
  EXPECT(nearest < diameter);
  EXPECT(nearest > 0.9 * diameter);
}
