#pragma once

#include "scaling.hpp"
#include "system.hpp"

namespace isostretch::sdp_penalty {

// One family of matrix inequalities M_i(x) >= floor I as the interior point sees it: slacks Z_i = M_i - floor
// I and multipliers Y_i, both positive definite, and a direction of them in the space where Nesterov and
// Todd's scaling makes both diag(l). M is affine in x; blocks are size x size.
class Cone {
 public:
  explicit Cone(int size) : size_(static_cast<std::size_t>(size)) {}

  // Z from M with eigenvalues of at least `least`, Y = complementarity Z^-1.
  void start(Blocks M, double floor, double least, double complementarity);
  // M at the next x.
  void update(Blocks M) { M_ = std::move(M); }

  // False where rounding has taken Z or Y to the boundary.
  bool scale();
  // W with W Z W = Y: the Newton matrix has the form sum tr(W dM W dM).
  const Blocks& weight() const { return scaling_.weight; }

  // What the scaled directions have to add up to: centre I - diag(l)^2, less the second-order term of the
  // direction before if asked.
  void set_target(double centre, bool correct);
  // Adds to the aim what would bring the eigenvalues of the scaled product of Z and Y at a longer step along
  // the direction back between a tenth of `centre` and ten times that.
  void recentre(double step, double centre);
  // The multipliers whose adjoint is minus this family's part of the gradient.
  Blocks dual_residual() const;
  // From the change of M along dx.
  void set_direction(const Blocks& change_of_M);
  // Puts the direction aside, and takes it back.
  void keep_direction();
  void restore_direction();
  // Largest step <= limit that keeps Z and Y positive semi-definite.
  double longest_step(double limit) const;
  void advance(double step);

  double complementarity() const;  // <Z, Y>
  std::size_t eigenvalues() const { return Z_.size() / size_; }
  const Blocks& multipliers() const { return Y_; }
  const Blocks& matrices() const { return M_; }

 private:
  std::size_t at(std::size_t block, std::size_t r, std::size_t c) const {
    return (block * size_ + r) * size_ + c;
  }
  Blocks products_at(double step) const;

  std::size_t size_;
  double floor_ = 0;
  Scaling scaling_;
  Blocks M_, Z_, Y_, residual_ /* M - floor I - Z */, target_, dZ_, dY_, change_Z_;
  Blocks kept_dZ_, kept_dY_, kept_change_Z_;
};

}  // namespace isostretch::sdp_penalty
