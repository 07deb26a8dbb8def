// Patterns drawn at random: elements of any size, chains, stars, dense rows, in any order, merged in any way.
#include "every_level.hpp"
#include "matrices.hpp"
#include "threads.hpp"

#include <isostretch/cholesky/factor.hpp>

#include <doctest/doctest.h>

#include <Eigen/Dense>

#include <random>
#include <vector>

using namespace isostretch;
using namespace isostretch::cholesky;
using namespace isostretch::cholesky::test;

namespace {

class Drawing {
 public:
  explicit Drawing(unsigned seed) : random_(seed) {}

  int below(int end) { return static_cast<int>(random_() % static_cast<unsigned>(end)); }

  Matrix matrix() {
    const int n = 1 + below(below(2) == 0 ? 12 : 90);
    Eigen::MatrixXd A = Eigen::MatrixXd::Zero(n, n);
    const auto couple = [&](int a, int b) {
      if (a != b) A(a, b) = A(b, a) = std::uniform_real_distribution<double>(-1, 1)(random_);
    };
    for (int elements = below(2 * n); elements > 0; --elements) {
      std::vector<int> node(static_cast<std::size_t>(1 + below(below(4) == 0 ? 12 : 4)));
      for (int& one : node) one = below(n);
      for (const int a : node)
        for (const int b : node) couple(a, b);
    }
    if (below(3) == 0)
      for (int a = below(n); a + 1 < n; ++a) couple(a, a + 1);
    for (int full = below(4) == 0 ? 1 + below(2) : 0; full > 0; --full)
      for (int a = 0, hub = below(n); a < n; ++a) couple(a, hub);
    for (int a = 0; a < n; ++a) A(a, a) = A.col(a).cwiseAbs().sum() + 0.1;
    return lower(A);
  }

  Amalgamation merge() {
    if (below(2) == 0) return {};
    return {{below(8), 8 + below(30), 40},
            {0.1 * below(11), 0.1 * below(11), 0.1 * below(11), 0.1 * below(11)}};
  }

 private:
  std::mt19937 random_;
};

// Factor, refactorization and Schur complement of one drawing against dense ones.
void check(unsigned seed) {
  CAPTURE(seed);
  Drawing draw(seed);
  const Matrix A = draw.matrix();
  const int last = draw.below(A.size + 1);
  const std::vector<int> order = shuffled(A.size, seed);
  const Analysis analysis(A.pattern(), order, draw.merge(), last);
  set_threads(1 + draw.below(4));
  Factor factor(analysis);
  REQUIRE(factor.factorize(A.value.data()));
  REQUIRE(factor.refactorize(A.value.data()));
  const Eigen::MatrixXd dense = A.dense(), inverse = dense.inverse();
  const Eigen::MatrixXd B = Eigen::MatrixXd::Random(A.size, 1 + draw.below(12));
  Eigen::MatrixXd X(A.size, B.cols());
  factor.solve(B.data(), X.data(), static_cast<int>(B.cols()));
  CHECK((dense * X - B).norm() <= 1e-14 * (dense.norm() * X.norm() + B.norm()));

  Eigen::MatrixXd S(last, last);
  factor.schur_complement(S.data());
  const std::vector<int> chosen(order.end() - last, order.end());
  CHECK((S * inverse(chosen, chosen) - Eigen::MatrixXd::Identity(last, last)).norm() <= 1e-11 * (1 + last));
}

}  // namespace

TEST_CASE("patterns drawn at random, in any order, merged in any way, with any number of threads") {
  tests::at_every_level([] {
    for (unsigned seed = 0; seed < 100; ++seed) check(seed);
  });
  set_threads(0);
}
