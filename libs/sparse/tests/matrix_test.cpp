#include "matrices.hpp"

#include <isostretch/core/error.hpp>
#include <isostretch/sparse/options.hpp>

#include <doctest/doctest.h>

#include <Eigen/Dense>

#include <limits>

using namespace isostretch;
using namespace isostretch::sparse;

namespace {

SymmetricMatrix small() {
  // [4 1 0; 1 5 2; 0 2 6]
  return {3, {0, 2, 4, 5}, {0, 1, 1, 2, 2}, {4, 1, 5, 2, 6}, {}};
}

void refused(const SymmetricMatrix& A, const char* message) {
  CHECK_THROWS_WITH_AS(A.validate(), doctest::Contains(message), Error);
}

}  // namespace

TEST_CASE("symmetric matrix: multiplication uses both triangles") {
  Eigen::VectorXd x(3), expected(3);
  x << 1, 2, 3;
  expected << 6, 17, 22;
  CHECK(small().multiply(x) == expected);
}

TEST_CASE("symmetric matrix: lower triangle of an Eigen matrix multiplies alike") {
  const SymmetricMatrix A = test::random_spd(40, 3, 1);
  A.validate();
  Eigen::SparseMatrix<double> lower = Eigen::Map<const Eigen::SparseMatrix<double>>(
      A.size, A.size, A.nonzeros(), A.column_start.data(), A.row.data(), A.value.data());
  const Eigen::VectorXd x = test::random_vector(40, 2);
  const Eigen::VectorXd expected = lower.selfadjointView<Eigen::Lower>() * x;
  CHECK((A.multiply(x) - expected).norm() < 1e-14 * expected.norm());
}

TEST_CASE("symmetric matrix: every fault is refused by name") {
  small().validate();
  SymmetricMatrix A = small();
  A.size = -1;
  refused(A, "negative size -1");
  A = small();
  A.column_start.pop_back();
  refused(A, "column_start has 3 entries");
  A = small();
  A.column_start[0] = 1;
  refused(A, "column_start[0] is 1");
  A = small();
  A.value.pop_back();
  refused(A, "5 rows but 4 values");
  A = small();
  A.column_start = {0, 4, 2, 5};
  refused(A, "column_start decreases after column 1");
  A = small();
  A.column_start[3] = 9;
  refused(A, "column_start ends at 9");
  A = small();
  A.row[2] = 2;
  refused(A, "no diagonal entry in column 1");
  A = small();
  A.column_start = {0, 2, 2, 5};
  refused(A, "no diagonal entry in column 1");
  A = small();
  A.row[2] = 0;
  refused(A, "above the diagonal: row 0, column 1");
  A = small();
  A.row[1] = 0;
  refused(A, "not strictly increasing: row 0, column 0");
  A = small();
  A.row[3] = 3;
  refused(A, "outside of size 3: row 3, column 1");
  A = small();
  A.group = {0, 1};
  refused(A, "group has 2 entries for 3 unknowns");
  A.group = {0, 1, 0};
  refused(A, "group decreases at unknown 2");
}

TEST_CASE("symmetric matrix: NaN and infinity are named by row and column") {
  SymmetricMatrix A = small();
  A.require_finite();
  A.value[3] = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_WITH_AS(A.require_finite(), doctest::Contains("NaN at row 2, column 1"), Error);
  A.value[3] = -std::numeric_limits<double>::infinity();
  CHECK_THROWS_WITH_AS(A.require_finite(), doctest::Contains("infinity at row 2, column 1"), Error);
  A.value[3] = std::numeric_limits<double>::max();
  A.require_finite();
}

TEST_CASE("sparse options: names go both ways, unknown ones are refused with the list") {
  for (const Backend backend : available_backends()) {
    CHECK(backend_from_name(backend_name(backend)) == backend);
    CHECK(is_available(backend));
  }
  for (const Ordering ordering : available_orderings())
    CHECK(ordering_from_name(ordering_name(ordering)) == ordering);
  for (const Preconditioner p : {Preconditioner::jacobi, Preconditioner::block_jacobi})
    CHECK(preconditioner_from_name(preconditioner_name(p)) == p);
  CHECK_THROWS_WITH_AS(backend_from_name("mkl"),
                       doctest::Contains("'mkl'; there are automatic, cholmod_supernodal"), Error);
  CHECK_THROWS_WITH_AS(ordering_from_name("rcm"), doctest::Contains("amd, metis, natural"), Error);
  CHECK_THROWS_WITH_AS(preconditioner_from_name("ilu"), doctest::Contains("jacobi, block_jacobi"), Error);
}
