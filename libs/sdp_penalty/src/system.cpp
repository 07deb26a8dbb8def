#include "system.hpp"

#include "small_matrix.hpp"

#include <algorithm>
#include <cmath>

namespace isostretch::sdp_penalty {
namespace {

std::size_t size(int n) {
  return static_cast<std::size_t>(n);
}

// R^T F, not made symmetric.
template <int D>
Small<D> unrotated(const Problem& problem, std::size_t e, const Vector& x) {
  constexpr int nodes = D + 1;
  const int* node = problem.elements.nodes.data() + e * nodes;
  const double* g = problem.elements.gradients.data() + e * nodes * D;
  Small<D> F;
  for (int a = 0; a < nodes; ++a)
    for (int r = 0; r < D; ++r)
      for (int c = 0; c < D; ++c) F(r, c) += x[node[a] * D + r] * g[a * D + c];
  return transposed(load<D>(problem.rotations.data() + e * D * D)) * F;
}

template <class Two, class Three>
auto by_dim(int dim, const Two& two, const Three& three) {
  return dim == 2 ? two() : three();
}

}  // namespace

System::System(const Problem& problem) : problem_(problem), dim_(problem.dim()), nodes_(problem.dim() + 1) {
  slot_size_ = size(nodes_ * (nodes_ + 1) / 2 * dim_ * dim_);
  assembly::PatternBuilder builder(problem.node_count());
  for (std::size_t e = 0; e < blocks(); ++e)
    builder.add_clique(problem.elements.nodes.data() + e * size(nodes_), nodes_);
  pattern_ = assembly::HessianPattern(assembly::FreeUnknowns(dim_, problem.node_count()), std::move(builder));
  index_entries();
  quadratic_ = pattern_.zero_matrix();
  linear_.setZero(unknowns());
  by_dim(
      dim_, [&] { assemble_quadratic<2>(); }, [&] { assemble_quadratic<3>(); });
}

void System::index_entries() {
  const int d = dim_;
  entry_.resize(blocks() * slot_size_);
  std::size_t k = 0;
  for (std::size_t e = 0; e < blocks(); ++e) {
    const int* node = problem_.elements.nodes.data() + e * size(nodes_);
    for (int a = 0; a < nodes_; ++a)
      for (int b = a; b < nodes_; ++b) {
        const int* positions = pattern_.positions(pattern_.block(node[a], node[b]));
        // Slots hold (row of a, column of b); the pattern has the larger node in the rows.
        for (int r = 0; r < d; ++r)
          for (int c = 0; c < d; ++c)
            entry_[k++] = node[a] < node[b] ? positions[c * d + r] : positions[r * d + c];
      }
  }
}

void System::scatter(std::size_t e, const double* slot, double* values) const {
  const int* entry = entry_.data() + e * slot_size_;
  for (std::size_t k = 0; k < slot_size_; ++k)
    if (entry[k] >= 0) values[entry[k]] += slot[k];
}

// 2 w |F|^2 / 2, the trace term, and alpha on targets; c collects what is linear in x, constant_ the rest.
template <int Dim>
void System::assemble_quadratic() {
  constexpr int nodes = Dim + 1;
  const double kappa = problem_.incompressibility;
  std::vector<double> slot(slot_size_);
  for (std::size_t e = 0; e < blocks(); ++e) {
    const int* node = problem_.elements.nodes.data() + e * nodes;
    const double* g = problem_.elements.gradients.data() + e * nodes * Dim;
    const Small<Dim> R = load<Dim>(problem_.rotations.data() + e * Dim * Dim);
    const double w = problem_.weights[e];
    double Rg[nodes][Dim];  // the gradient of tr(R^T F), and of F : R
    for (int a = 0; a < nodes; ++a)
      for (int r = 0; r < Dim; ++r) {
        Rg[a][r] = 0;
        for (int c = 0; c < Dim; ++c) Rg[a][r] += R(r, c) * g[a * Dim + c];
        linear_[node[a] * Dim + r] += (2 * w + kappa * Dim) * Rg[a][r];
      }
    std::size_t k = 0;
    for (int a = 0; a < nodes; ++a)
      for (int b = a; b < nodes; ++b) {
        double dot = 0;
        for (int c = 0; c < Dim; ++c) dot += g[a * Dim + c] * g[b * Dim + c];
        for (int r = 0; r < Dim; ++r)
          for (int c = 0; c < Dim; ++c)
            slot[k++] = (r == c ? 2 * w * dot : 0.0) + kappa * Rg[a][r] * Rg[b][c];
      }
    scatter(e, slot.data(), quadratic_.value.data());
    constant_ += Dim * w + 0.5 * kappa * Dim * Dim;
  }
  for (const Target& target : problem_.targets) {
    const int* diagonal = pattern_.positions(pattern_.block(target.node, target.node));
    for (int r = 0; r < Dim; ++r) {
      const double d = target.position[size(r)];
      quadratic_.value[size(diagonal[r * Dim + r])] += 2 * problem_.alpha;
      linear_[target.node * Dim + r] += 2 * problem_.alpha * d;
      constant_ += problem_.alpha * d * d;
    }
  }
}

// Term by term instead of 1/2 x^T H0 x - c^T x + constant, which would lose digits to cancellation.
double System::objective(const Vector& x) const {
  double sum = target_energy(x);
  const auto elastic = [&]<int D>() {
    double total = 0;
    for (std::size_t e = 0; e < blocks(); ++e) {
      Small<D> G = unrotated<D>(problem_, e, x);  // |F - R| = |R^T F - I|
      double trace = -D;
      for (int i = 0; i < D; ++i) {
        trace += G(i, i);
        G(i, i) -= 1;
      }
      total += problem_.weights[e] * dot(G, G) + 0.5 * problem_.incompressibility * trace * trace;
    }
    return total;
  };
  return sum + (dim_ == 2 ? elastic.operator()<2>() : elastic.operator()<3>());
}

double System::target_energy(const Vector& x) const {
  double sum = 0;
  for (const Target& target : problem_.targets)
    for (int r = 0; r < dim_; ++r) {
      const double distance = x[target.node * dim_ + r] - target.position[size(r)];
      sum += distance * distance;
    }
  return problem_.alpha * sum;
}

void System::gradient(const Vector& x, Vector& g) const {
  g.resize(unknowns());
  quadratic_.multiply(x.data(), g.data());
  g -= linear_;
}

void System::constraints(const Vector& x, std::vector<double>& S) const {
  S.resize(blocks() * block_size());
  const auto fill = [&]<int D>() {
#pragma omp parallel for schedule(static)
    for (std::size_t e = 0; e < blocks(); ++e)
      store(symmetric_part(unrotated<D>(problem_, e, x)), S.data() + e * D * D);
  };
  by_dim(
      dim_, [&] { fill.operator()<2>(); }, [&] { fill.operator()<3>(); });
}

void System::add_adjoint(const std::vector<double>& M, Vector& g) const {
  const auto add = [&]<int D>() {
    constexpr int nodes = D + 1;
    for (std::size_t e = 0; e < blocks(); ++e) {
      const int* node = problem_.elements.nodes.data() + e * nodes;
      const double* b = problem_.elements.gradients.data() + e * nodes * D;
      const Small<D> RM = load<D>(problem_.rotations.data() + e * D * D) * load<D>(M.data() + e * D * D);
      for (int a = 0; a < nodes; ++a)
        for (int r = 0; r < D; ++r)
          for (int c = 0; c < D; ++c) g[node[a] * D + r] += RM(r, c) * b[a * D + c];
    }
  };
  by_dim(
      dim_, [&] { add.operator()<2>(); }, [&] { add.operator()<3>(); });
}

// With q_a = R W b_a the block of nodes a and b is 1/2 (b_a . W b_b R W R^T + q_b q_a^T).
template <int Dim>
void System::element_weighted(const double* W, std::size_t e, double* slot) const {
  constexpr int nodes = Dim + 1;
  const double* g = problem_.elements.gradients.data() + e * nodes * Dim;
  const Small<Dim> R = load<Dim>(problem_.rotations.data() + e * Dim * Dim);
  const Small<Dim> RW = R * load<Dim>(W), P = RW * transposed(R);
  double q[nodes][Dim], Wg[nodes][Dim];
  for (int a = 0; a < nodes; ++a)
    for (int r = 0; r < Dim; ++r) {
      q[a][r] = Wg[a][r] = 0;
      for (int c = 0; c < Dim; ++c) {
        q[a][r] += RW(r, c) * g[a * Dim + c];
        Wg[a][r] += W[r * Dim + c] * g[a * Dim + c];
      }
    }
  for (int a = 0; a < nodes; ++a)
    for (int b = a; b < nodes; ++b) {
      double dot = 0;
      for (int c = 0; c < Dim; ++c) dot += g[a * Dim + c] * Wg[b][c];
      for (int r = 0; r < Dim; ++r)
        for (int c = 0; c < Dim; ++c) *slot++ = 0.5 * (dot * P(r, c) + q[b][r] * q[a][c]);
    }
}

void System::weighted(const std::vector<double>& W, sparse::SymmetricMatrix& matrix) const {
  matrix.value = quadratic_.value;
  std::vector<double> slot(slot_size_);
  for (std::size_t e = 0; e < blocks(); ++e) {
    by_dim(
        dim_, [&] { element_weighted<2>(W.data() + e * 4, e, slot.data()); },
        [&] { element_weighted<3>(W.data() + e * 9, e, slot.data()); });
    scatter(e, slot.data(), matrix.value.data());
  }
}

std::vector<double> System::determinants(const Vector& x) const {
  std::vector<double> result(blocks());
  for (std::size_t e = 0; e < blocks(); ++e) {
    if (dim_ == 2) {
      const auto F = unrotated<2>(problem_, e, x);
      result[e] = F(0, 0) * F(1, 1) - F(0, 1) * F(1, 0);
    } else {
      const auto F = unrotated<3>(problem_, e, x);
      result[e] = F(0, 0) * (F(1, 1) * F(2, 2) - F(1, 2) * F(2, 1)) -
                  F(0, 1) * (F(1, 0) * F(2, 2) - F(1, 2) * F(2, 0)) +
                  F(0, 2) * (F(1, 0) * F(2, 1) - F(1, 1) * F(2, 0));
    }
  }
  return result;
}

}  // namespace isostretch::sdp_penalty
