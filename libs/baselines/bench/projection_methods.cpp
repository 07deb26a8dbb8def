// What projecting the Hessian costs a quadrature point, from F: our batches beside the four ways that Smith,
// de Goes, Kim (2019, section 6.2) compare with, on the F of a mesh twisted by 90 degrees (inverted
// tetrahedra are left out). One thread.
//
//   isostretch_projection_methods hand.mesh [energy ...]
//
// The rivals get psi's derivatives from the same energies; SVD and eigen-decompositions are Eigen's.
#include "../src/distortion/stomakhin_rule.hpp"
#include "../src/distortion/teran_rule.hpp"

#include <isostretch/energies/registry.hpp>
#include <isostretch/fem/element_arrays.hpp>
#include <isostretch/linalg/decompositions.hpp>
#include <isostretch/mesh_io/io.hpp>
#include <isostretch/projection/projection.hpp>

#include <Eigen/Dense>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <exception>
#include <string>
#include <vector>

namespace {

using namespace isostretch;
using Matrix9 = Eigen::Matrix<double, 9, 9>;
using Matrix12 = Eigen::Matrix<double, 12, 12>;

// Deformation gradients, rest gradients of nodes 1, 2, 3 and volumes of all tetrahedra.
struct Points {
  std::vector<Eigen::Matrix3d> F, gradients;
  std::vector<double> weights;
};

Points twisted(const mesh::TetMesh& mesh) {
  const Eigen::RowVector3d low = mesh.vertices.colwise().minCoeff(),
                           high = mesh.vertices.colwise().maxCoeff();
  int axis = 0;
  (high - low).maxCoeff(&axis);
  const int p = (axis + 1) % 3, q = (axis + 2) % 3;
  mesh::Points3 x = mesh.vertices;
  for (int v = 0; v < x.rows(); ++v) {
    const double angle = 0.5 * std::acos(-1.0) * (x(v, axis) - low[axis]) / (high[axis] - low[axis]);
    const double a = x(v, p) - 0.5 * (low[p] + high[p]), b = x(v, q) - 0.5 * (low[q] + high[q]);
    x(v, p) = std::cos(angle) * a - std::sin(angle) * b;
    x(v, q) = std::sin(angle) * a + std::cos(angle) * b;
  }
  const mesh::ElementArrays arrays = mesh::elements(mesh);
  Points points;
  for (int e = 0; e < arrays.element_count(); ++e) {
    Eigen::Matrix3d F = Eigen::Matrix3d::Zero(), g;
    for (int a = 0; a < 4; ++a) {
      const Eigen::Map<const Eigen::RowVector3d> gradient(arrays.gradients.data() + 12 * e + 3 * a);
      F += x.row(arrays.nodes[static_cast<std::size_t>(4 * e + a)]).transpose() * gradient;
      if (a > 0) g.row(a - 1) = gradient;
    }
    if (!(F.determinant() > 0)) continue;  // outside the domain of energies with a barrier
    points.F.push_back(F);
    points.gradients.push_back(g);
    points.weights.push_back(arrays.weights[static_cast<std::size_t>(e)]);
  }
  return points;
}

// Nanoseconds a point: the median of several passes.
template <class Pass>
double nanoseconds(const Points& points, const Pass& pass) {
  std::vector<double> times;
  double spent = 0;
  while (times.size() < 5 || (spent < 1 && times.size() < 50)) {
    const auto begin = std::chrono::steady_clock::now();
    pass();
    times.push_back(std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
    spent += times.back();
  }
  std::nth_element(times.begin(), times.begin() + static_cast<std::ptrdiff_t>(times.size() / 2), times.end());
  return 1e9 * times[times.size() / 2] / static_cast<double>(points.F.size());
}

double sink = 0;  // what the compiler must not leave out

Matrix12 element_block(const Matrix9& H, const Eigen::Matrix3d& g, double weight) {
  Eigen::Matrix<double, 9, 12> D = Eigen::Matrix<double, 9, 12>::Zero();
  for (int a = 1; a < 4; ++a)
    for (int r = 0; r < 3; ++r)
      for (int c = 0; c < 3; ++c) {
        D(r + 3 * c, 3 * a + r) = g(a - 1, c);
        D(r + 3 * c, r) -= g(a - 1, c);
      }
  return weight * D.transpose() * H * D;
}

// The exact Hessians are made beforehand and not timed: only their projection is.
double numerical_9x9(const Points& points, const std::vector<Matrix9>& exact) {
  return nanoseconds(points, [&] {
    for (const Matrix9& H : exact) sink += baselines::nearest_semidefinite<9>(H)(0, 0);
  });
}

double numerical_12x12(const Points& points, const std::vector<Matrix9>& exact) {
  std::vector<Matrix12> blocks;
  for (std::size_t i = 0; i < exact.size(); ++i)
    blocks.push_back(element_block(exact[i], points.gradients[i], points.weights[i]));
  return nanoseconds(points, [&] {
    for (const Matrix12& K : blocks) sink += baselines::nearest_semidefinite<12>(K)(0, 0);
  });
}

// Hessian over vec(F) from its entries in the frame of the singular vectors: vec(U X V^T) = (V x U) vec(X).
Matrix9 rotated_back(const Eigen::Matrix3d& U, const Eigen::Matrix3d& V,
                     const invariants::StretchDerivatives<3, double>& d) {
  Matrix9 local = Matrix9::Zero(), rotation;
  for (int i = 0; i < 3; ++i) {
    const int j = invariants::first<3>(i), k = invariants::second<3>(i);
    local(4 * i, 4 * i) = d.diagonal[i];
    local(4 * j, 4 * k) = local(4 * k, 4 * j) = d.coupling[i];
    local(j + 3 * k, j + 3 * k) = local(k + 3 * j, k + 3 * j) = 0.5 * (d.flip[i] + d.twist[i]);
    local(j + 3 * k, k + 3 * j) = local(k + 3 * j, j + 3 * k) = 0.5 * (d.flip[i] - d.twist[i]);
  }
  for (int r = 0; r < 3; ++r)
    for (int c = 0; c < 3; ++c) rotation.block<3, 3>(3 * r, 3 * c) = V(r, c) * U;
  return rotation * local * rotation.transpose();
}

// Teran et al. (2005) and Stomakhin et al. (2012): SVD, the rule in the frame of the singular vectors, and
// back. From F, with the SVD, as it has to be there.
template <class Rule>
double in_singular_frame(const Points& points, const energies::AnyEnergy& energy, const Rule& rule) {
  // Derivatives with respect to the singular values, not timed: they cost each method the same.
  std::vector<invariants::PrincipalStretches<3, double>> stretches;
  std::vector<invariants::StretchDerivatives<3, double>> derivatives;
  for (const auto& F : points.F) {
    const auto svd = linalg::signed_svd<3>(F);
    stretches.push_back({{svd.sigma[0], svd.sigma[1], svd.sigma[2]}});
    derivatives.push_back(energies::derivatives_at<3>(energy, stretches.back()));
  }
  return nanoseconds(points, [&] {
    for (std::size_t i = 0; i < points.F.size(); ++i) {
      Eigen::JacobiSVD<Eigen::Matrix3d> svd(points.F[i], Eigen::ComputeFullU | Eigen::ComputeFullV);
      Eigen::Matrix3d U = svd.matrixU(), V = svd.matrixV();
      if (U.determinant() < 0) U.col(2) *= -1;
      if (V.determinant() < 0) V.col(2) *= -1;
      auto d = derivatives[i];
      rule(stretches[i], d);
      sink += rotated_back(U, V, d)(0, 0);
    }
  });
}

// Everything from F: SVD, energy, stress and projected Hessian, to a buffer used again and again as an
// assembly does; the 9x9, or with it the element's gradient and 12x12.
double ours(const Points& points, const energies::AnyEnergy& energy, bool element) {
  constexpr std::size_t block = 64, step = 4 * block;
  const std::size_t count = points.F.size(), padded = (count + step - 1) / step * step;
  std::vector<double> F(9 * padded), gradients(9 * padded), weights(padded);
  for (std::size_t i = 0; i < padded; ++i) {
    const std::size_t from = std::min(i, count - 1), at = i / block * block * 9 + i % block;
    for (std::size_t e = 0; e < 9; ++e) {
      F[at + e * block] = points.F[from](static_cast<Eigen::Index>(e));
      gradients[at + e * block] =
          points.gradients[from](static_cast<Eigen::Index>(e / 3), static_cast<Eigen::Index>(e % 3));
    }
    weights[i] = points.weights[from];
  }
  std::vector<double> psi(step), P(9 * step), H(45 * step), G(12 * step), K(78 * step);
  return nanoseconds(points, [&] {
    for (std::size_t begin = 0; begin < count; begin += step) {
      projection::HessianBatch batch{F.data() + 9 * begin, psi.data(), P.data(), H.data()};
      batch.count = std::min(step, count - begin);
      batch.block = block;
      if (element) {
        batch.gradients = gradients.data() + 9 * begin;
        batch.weights = weights.data() + begin;
        batch.G = G.data();
        batch.K = K.data();
        batch.H = nullptr;
      }
      projection::evaluate(energy, 3, {}, batch);
      sink += element ? K[0] : H[0];
    }
  });
}

int run(int argc, char** argv) {
  if (argc < 2) throw Error("arguments: tetrahedral mesh, energies");
  const Points points = twisted(mesh::read_tets(argv[1]));
  std::vector<std::string> names(argv + 2, argv + argc);
  if (names.empty()) names = {"symmetric_dirichlet", "symmetric_arap", "st_venant_kirchhoff"};
  std::printf(
      "| %zu points | indefinite | ours 9x9 | ours 12x12 | numerical 9x9 | numerical 12x12 | Teran | "
      "Stomakhin |\n",
      points.F.size());
  for (const std::string& name : names) {
    const auto energy = energies::make_energy(name);
    std::vector<Matrix9> exact;
    std::size_t indefinite = 0;
    for (const auto& F : points.F) {
      exact.push_back(projection::evaluate<3>(energy, F, {projection::Filter::none}).H);
      indefinite += projection::evaluate<3>(energy, F).filtered;
    }
    const double nine = ours(points, energy, false), twelve = ours(points, energy, true);
    const double rival9 = numerical_9x9(points, exact), rival12 = numerical_12x12(points, exact),
                 teran = in_singular_frame(points, energy, baselines::TeranRule{}),
                 stomakhin = in_singular_frame(points, energy, baselines::StomakhinRule{});
    std::printf(
        "| %s | %.0f %% | %.0f ns | %.0f ns | %.0f ns, %.1fx | %.0f ns, %.1fx | %.0f ns, %.1fx | %.0f ns, "
        "%.1fx |\n",
        name.c_str(), 100.0 * static_cast<double>(indefinite) / static_cast<double>(points.F.size()), nine,
        twelve, rival9, rival9 / nine, rival12, rival12 / twelve, teran, teran / nine, stomakhin,
        stomakhin / nine);
  }
  return std::isfinite(sink) ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
