#include "system.hpp"

#include <isostretch/assembly/least_parallel.hpp>
#include <isostretch/sdp_penalty/element.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace isostretch::sdp_penalty {
namespace {

using linalg::Mat;

std::size_t size(int n) {
  return static_cast<std::size_t>(n);
}

template <class Two, class Three>
auto by_dim(int dim, const Two& two, const Three& three) {
  return dim == 2 ? two() : three();
}

std::vector<int> hard_nodes(const Problem& problem) {
  std::vector<int> nodes;
  for (const Target& target : problem.targets)
    if (target.hard) nodes.push_back(target.node);
  std::sort(nodes.begin(), nodes.end());
  return nodes;
}

}  // namespace

System::System(const Problem& problem)
    : problem_(&problem),
      dim_(problem.dim()),
      restriction_(problem.elements),
      hard_nodes_(hard_nodes(problem)) {
  assembly::PatternBuilder builder(problem.node_count());
  restriction_.add_stencil(builder);
  std::vector<bool> pinned(hard_nodes_.empty() ? 0 : size(dim_ * problem.node_count()), false);
  for (const int node : hard_nodes_)
    for (int r = 0; r < dim_; ++r) pinned[size(dim_ * node + r)] = true;
  pattern_ = assembly::HessianPattern(assembly::FreeUnknowns(dim_, problem.node_count(), pinned),
                                      std::move(builder));
  blocks_ = assembly::BlockAssembler(restriction_, pattern_);
  quadratic_ = pattern_.zero_matrix();
  set_problem(problem);
}

bool System::has_structure_of(const Problem& problem) const {
  return problem.dim() == dim_ && problem.elements.nodes == restriction_.nodes() &&
         dim_ * problem.node_count() == pattern_.unknowns().dofs() && hard_nodes(problem) == hard_nodes_;
}

void System::set_problem(const Problem& problem) {
  problem_ = &problem;
  by_dim(
      dim_, [&] { assemble_quadratic<2>(); }, [&] { assemble_quadratic<3>(); });
}

// The elastic term, and 2 alpha at soft targets.
template <int D>
void System::assemble_quadratic() {
  std::fill(quadratic_.value.begin(), quadratic_.value.end(), 0.0);
  blocks_.add_computed<D, D + 1>(
      [&](std::size_t e, int a, int b, Mat<D>& sum) { add_elastic_block<D>(*problem_, e, a, b, sum); },
      quadratic_.value.data());
  for (const Target& target : problem_->targets) {
    if (target.hard) continue;
    const int* diagonal = pattern_.positions(pattern_.block(target.node, target.node));
    for (int r = 0; r < D; ++r) quadratic_.value[size(diagonal[r * D + r])] += 2 * problem_->alpha;
  }
}

template <int D>
void System::store_forces(std::size_t e, const Mat<D>& P, std::vector<double>& corners) const {
  deformation<D>(*problem_).apply_transposed(
      e, P, [&](int a, int r, double value) { corners[(e * (D + 1) + size(a)) * D + size(r)] = value; });
}

Vector System::with_hard_targets(Vector x) const {
  for (const Target& target : problem_->targets)
    for (int r = 0; target.hard && r < dim_; ++r) x[target.node * dim_ + r] = target.position[size(r)];
  return x;
}

Vector System::restrict_to_unknowns(const Vector& positions) const {
  Vector result(unknowns());
  for (int i = 0; i < unknowns(); ++i) result[i] = positions[pattern_.unknowns().dof(i)];
  return result;
}

Vector System::prolongate(const Vector& reduced) const {
  Vector result = Vector::Zero(pattern_.unknowns().dofs());
  for (int i = 0; i < unknowns(); ++i) result[pattern_.unknowns().dof(i)] = reduced[i];
  return result;
}

double System::change_of_objective(const Vector& g, const Vector& dx, double step) const {
  const Vector direction = restrict_to_unknowns(dx);
  Vector image(direction.size());
  quadratic_.multiply(direction.data(), image.data());
  return step * g.dot(dx) + 0.5 * step * step * direction.dot(image);
}

void System::gradient(const Vector& x, Vector& g) const {
  g.setZero(pattern_.unknowns().dofs());
  const auto elastic = [&]<int D>() {
    std::vector<double> corners(restriction_.nodes().size() * D);
#pragma omp parallel for schedule(static) if (blocks() > assembly::least_parallel)
    for (std::size_t e = 0; e < blocks(); ++e) {
      Mat<D> G = unrotated<D>(*problem_, e, x);
      double trace = -D;
      for (int i = 0; i < D; ++i) trace += G[i][i];
      for (int i = 0; i < D; ++i) G[i][i] -= 1;
      G *= 2 * problem_->weights[e];
      for (int i = 0; i < D; ++i) G[i][i] += problem_->incompressibility * trace;
      store_forces(e, rotation<D>(*problem_, e) * G, corners);
    }
    restriction_.add_transposed(D, corners.data(), g.data());
  };
  by_dim(
      dim_, [&] { elastic.operator()<2>(); }, [&] { elastic.operator()<3>(); });
  for (const Target& target : problem_->targets)
    for (int r = 0; r < dim_; ++r) {
      double& entry = g[target.node * dim_ + r];
      if (!target.hard) entry += 2 * problem_->alpha * (x[target.node * dim_ + r] - target.position[size(r)]);
    }
}

void System::constraints(const Vector& x, Blocks& S) const {
  S.resize(blocks() * block_size());
  const auto fill = [&]<int D>() {
#pragma omp parallel for schedule(static) if (blocks() > assembly::least_parallel)
    for (std::size_t e = 0; e < blocks(); ++e)
      to_rows(symmetric_part(unrotated<D>(*problem_, e, x)), S.data() + e * D * D);
  };
  by_dim(
      dim_, [&] { fill.operator()<2>(); }, [&] { fill.operator()<3>(); });
}

void System::add_adjoint(const Blocks& M, Vector& g) const {
  const auto add = [&]<int D>() {
    std::vector<double> corners(restriction_.nodes().size() * D);
#pragma omp parallel for schedule(static) if (blocks() > assembly::least_parallel)
    for (std::size_t e = 0; e < blocks(); ++e) {
      const Mat<D> RM = rotation<D>(*problem_, e) * linalg::from_rows<D>(M.data() + e * D * D);
      store_forces(e, RM, corners);
    }
    restriction_.add_transposed(D, corners.data(), g.data());
  };
  by_dim(
      dim_, [&] { add.operator()<2>(); }, [&] { add.operator()<3>(); });
}

// Blocks of 2 D x 2 D: `diagonal` times the identity, and R^T F with its transpose beside.
Blocks System::stretch_blocks(const Vector& x, double diagonal) const {
  const auto d = size(dim_), entries = 4 * d * d;
  Blocks B(blocks() * entries, 0.0);
  const auto fill = [&]<int D>() {
#pragma omp parallel for schedule(static) if (blocks() > assembly::least_parallel)
    for (std::size_t e = 0; e < blocks(); ++e) {
      const Mat<D> G = unrotated<D>(*problem_, e, x);
      double* b = B.data() + e * entries;
      for (std::size_t r = 0; r < D; ++r) {
        b[r * 2 * D + r] = b[(D + r) * 2 * D + D + r] = diagonal;
        for (std::size_t c = 0; c < D; ++c) b[r * 2 * D + D + c] = b[(D + c) * 2 * D + r] = G.m[r][c];
      }
    }
  };
  by_dim(
      dim_, [&] { fill.operator()<2>(); }, [&] { fill.operator()<3>(); });
  return B;
}

Constrained System::constrained(const Vector& x) const {
  Constrained result;
  constraints(x, result.orientation);
  if (problem_->bounds_stretch()) result.stretch = stretch_blocks(x, problem_->largest_stretch);
  return result;
}

Constrained System::change_of_constrained(const Vector& dx) const {
  Constrained result;
  constraints(dx, result.orientation);
  if (problem_->bounds_stretch()) result.stretch = stretch_blocks(dx, 0);
  return result;
}

// <M, B> has twice the upper right quarter of M with R^T F.
void System::add_stretch_adjoint(const Blocks& M, Vector& g) const {
  const auto d = size(dim_);
  Blocks quarter(blocks() * d * d);
  for (std::size_t e = 0; e < blocks(); ++e)
    for (std::size_t r = 0; r < d; ++r)
      for (std::size_t c = 0; c < d; ++c)
        quarter[(e * d + r) * d + c] = 2 * M[(e * 2 * d + r) * 2 * d + d + c];
  add_adjoint(quarter, g);
}

// With W = [[P, Q], [Q^T, T]] the form is 2 tr(P D T D^T) + 2 tr(Q^T D Q^T D), D = R^T dF.
template <int D>
void System::stretch_weighted_blocks(const Blocks& W, sparse::SymmetricMatrix& matrix) const {
  blocks_.add_computed<D, D + 1>(
      [&](std::size_t e, int a, int b, Mat<D>& sum) {
        const double* w = W.data() + e * 4 * D * D;
        const double *ga = rest_gradients<D>(*problem_, e) + a * D,
                     *gb = rest_gradients<D>(*problem_, e) + b * D;
        Mat<D> P;
        std::array<double, D> Qa{}, Qb{};
        double dot = 0;
        for (int r = 0; r < D; ++r)
          for (int c = 0; c < D; ++c) {
            P[r][c] = w[r * 2 * D + c];
            Qa[size(r)] += w[r * 2 * D + D + c] * ga[c];
            Qb[size(r)] += w[r * 2 * D + D + c] * gb[c];
            dot += ga[r] * w[(D + r) * 2 * D + D + c] * gb[c];
          }
        Mat<D> N{};
        for (int r = 0; r < D; ++r)
          for (int c = 0; c < D; ++c) N[r][c] = 2 * (P[r][c] * dot + Qb[size(r)] * Qa[size(c)]);
        const Mat<D> R = rotation<D>(*problem_, e);
        sum += R * N * transposed(R);
      },
      matrix.value.data());
}

void System::add_stretch_weighted(const Blocks& W, sparse::SymmetricMatrix& matrix) const {
  by_dim(
      dim_, [&] { stretch_weighted_blocks<2>(W, matrix); }, [&] { stretch_weighted_blocks<3>(W, matrix); });
}

void subtract_adjoint(const System& system, Constrained multipliers, Vector& g) {
  for (double& entry : multipliers.orientation) entry = -entry;
  system.add_adjoint(multipliers.orientation, g);
  if (multipliers.stretch.empty()) return;
  for (double& entry : multipliers.stretch) entry = -entry;
  system.add_stretch_adjoint(multipliers.stretch, g);
}

// With q_a = R W g_a the block of corners a and b is 1/2 (g_a . W g_b R W R^T + q_b q_a^T).
template <int D>
void System::weighted_blocks(const Blocks& W, sparse::SymmetricMatrix& matrix) {
  constexpr std::size_t stride = D * D + (D + 1) * D;
  image_.resize(blocks() * stride);
#pragma omp parallel for schedule(static) if (blocks() > assembly::least_parallel)
  for (std::size_t e = 0; e < blocks(); ++e) {
    const Mat<D> R = rotation<D>(*problem_, e), RW = R * linalg::from_rows<D>(W.data() + e * D * D);
    double* image = image_.data() + e * stride;
    to_rows(RW * transposed(R), image);
    deformation<D>(*problem_).apply_transposed(e, RW,
                                               [&](int a, int r, double q) { image[D * D + a * D + r] = q; });
  }
  blocks_.add_computed<D, D + 1>(
      [&](std::size_t e, int a, int b, Mat<D>& sum) {
        const double *P = image_.data() + e * stride, *q = P + D * D, *g = rest_gradients<D>(*problem_, e);
        const double *w = W.data() + e * D * D, *ga = g + a * D, *gb = g + b * D;
        double dot = 0;
        for (int r = 0; r < D; ++r)
          for (int c = 0; c < D; ++c) dot += ga[r] * w[r * D + c] * gb[c];
        for (int r = 0; r < D; ++r)
          for (int c = 0; c < D; ++c) sum[r][c] += 0.5 * (dot * P[r * D + c] + q[b * D + r] * q[a * D + c]);
      },
      matrix.value.data());
}

void System::assemble_normal_equations(const Blocks& W, sparse::SymmetricMatrix& matrix) {
  matrix.value = quadratic_.value;
  by_dim(
      dim_, [&] { weighted_blocks<2>(W, matrix); }, [&] { weighted_blocks<3>(W, matrix); });
}

// With U = R Q and G_a = Q^T g_a the block is U N U^T, N_jk = 1/2 (h_jk G_ak G_bj + [j = k] sum_l h_jl G_al
// G_bl).
template <int D>
void System::curved_blocks(const SpectralCurvature& curvature, sparse::SymmetricMatrix& matrix) const {
  blocks_.add_computed<D, D + 1>(
      [&](std::size_t e, int a, int b, Mat<D>& sum) {
        if (!curvature.active[e]) return;
        const Mat<D> Q = linalg::from_rows<D>(curvature.Q.data() + e * D * D),
                     U = rotation<D>(*problem_, e) * Q;
        const Mat<D> h = linalg::from_rows<D>(curvature.h.data() + e * D * D);
        const double *ga = rest_gradients<D>(*problem_, e) + a * D,
                     *gb = rest_gradients<D>(*problem_, e) + b * D;
        std::array<double, D> Ga{}, Gb{};
        for (int k = 0; k < D; ++k)
          for (int c = 0; c < D; ++c) {
            Ga[size(k)] += Q[c][k] * ga[c];
            Gb[size(k)] += Q[c][k] * gb[c];
          }
        Mat<D> N{};
        for (int j = 0; j < D; ++j)
          for (int k = 0; k < D; ++k) {
            N[j][k] += 0.5 * h[j][k] * Ga[size(k)] * Gb[size(j)];
            N[j][j] += 0.5 * h[j][k] * Ga[size(k)] * Gb[size(k)];
          }
        sum += U * N * transposed(U);
      },
      matrix.value.data());
}

void System::assemble_hessian(const SpectralCurvature& curvature, sparse::SymmetricMatrix& matrix) const {
  matrix.value = quadratic_.value;
  by_dim(
      dim_, [&] { curved_blocks<2>(curvature, matrix); }, [&] { curved_blocks<3>(curvature, matrix); });
}

std::vector<double> System::determinants(const Vector& x) const {
  std::vector<double> result(blocks());
  const auto fill = [&]<int D>() {
#pragma omp parallel for schedule(static) if (blocks() > assembly::least_parallel)
    for (std::size_t e = 0; e < blocks(); ++e) result[e] = determinant(unrotated<D>(*problem_, e, x));
  };
  by_dim(
      dim_, [&] { fill.operator()<2>(); }, [&] { fill.operator()<3>(); });
  return result;
}

}  // namespace isostretch::sdp_penalty
