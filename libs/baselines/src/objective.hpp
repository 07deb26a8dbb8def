#pragma once

#include <isostretch/core/vector.hpp>
#include <isostretch/sdp_penalty/problem.hpp>

#include <span>
#include <vector>

namespace isostretch::baselines {

// A function of positions to minimise, for solvers of nonlinear programs. Its Hessian is constant: a block
// for the unknowns of each element (corners.hpp), and a diagonal.
class Objective {
 public:
  virtual ~Objective() = default;
  virtual double value(const Vector& x) const = 0;
  virtual void gradient(const Vector& x, std::span<double> g) const = 0;
  // block += factor * the element's, the first entries of rows of `columns`.
  virtual void add_hessian(int element, double factor, std::span<double> block, int columns) const = 0;
  virtual double hessian_diagonal(int dof) const = 0;
};

// The energy of the convex problem, which must outlive this.
class EnergyObjective : public Objective {
 public:
  explicit EnergyObjective(const sdp_penalty::Problem& problem);
  double value(const Vector& x) const override;
  void gradient(const Vector& x, std::span<double> g) const override;
  void add_hessian(int element, double factor, std::span<double> block, int columns) const override;
  double hessian_diagonal(int dof) const override;

 private:
  void add_elastic_gradient(const Vector& x, std::span<double> g) const;

  const sdp_penalty::Problem& problem_;
  std::vector<double> target_curvature_;  // 2 alpha for every soft target of the entry's node
};

}  // namespace isostretch::baselines
