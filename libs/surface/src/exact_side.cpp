#include "exact_side.hpp"

#include <isostretch/mesh/accurate.hpp>

#include <cmath>

namespace isostretch::mesh {
namespace {

// Of the error of the determinant in floating point against the sum of its two products (Shewchuk, "Adaptive
// precision floating-point arithmetic and fast robust geometric predicates", 1997); and of what underflow
// adds.
constexpr double relative_error = 3.3306690738754716e-16, absolute_error = 1e-290;
// How much may cancel before the value itself, not only its sign, is computed exactly.
constexpr double cancellation = 8;

// The rounding error of the sum a + b.
double sum_error(double a, double b, double sum) {
  const double of_b = sum - a;
  return (a - (sum - of_b)) + (b - of_b);
}

// A sum without any rounding, as numbers that do not overlap, smallest first.
class Expansion {
 public:
  void add(double term) {
    for (int i = 0; i < size_; ++i) {
      const double sum = term + parts_[i];
      parts_[i] = sum_error(term, parts_[i], sum);
      term = sum;
    }
    parts_[size_++] = term;
  }
  void add_product(double a, double b) {
    const double product = a * b;
    add(std::fma(a, b, -product));
    add(product);
  }
  double value() const {
    double sum = 0;
    for (int i = 0; i < size_; ++i) sum += parts_[i];
    return sum;
  }

 private:
  double parts_[12] = {};
  int size_ = 0;
};

double exact_area(const PlanePoint& a, const PlanePoint& b, const PlanePoint& c) {
  Expansion sum;
  for (const auto& [p, q] : {std::pair{&a, &b}, std::pair{&b, &c}, std::pair{&c, &a}}) {
    sum.add_product((*p)[0], (*q)[1]);
    sum.add_product(-(*p)[1], (*q)[0]);
  }
  return sum.value();
}

bool rounded(double a, double b, double difference) {
  return sum_error(a, -b, difference) != 0;
}

// What the filter could not decide. Coordinates of one grid have differences without error.
double careful_area(const PlanePoint& a, const PlanePoint& b, const PlanePoint& c) {
  const double ax = a[0] - c[0], ay = a[1] - c[1], bx = b[0] - c[0], by = b[1] - c[1];
  if (rounded(a[0], c[0], ax) || rounded(a[1], c[1], ay) || rounded(b[0], c[0], bx) ||
      rounded(b[1], c[1], by))
    return exact_area(a, b, c);
  return product_difference(ax, by, ay, bx);
}

bool coincide(const PlanePoint& a, const PlanePoint& b, const PlanePoint& c) {
  return a == b || b == c || c == a;
}

int sign(double value) {
  return (value > 0) - (value < 0);
}

}  // namespace

int side(const PlanePoint& a, const PlanePoint& b, const PlanePoint& c) {
  const double left = (a[0] - c[0]) * (b[1] - c[1]), right = (a[1] - c[1]) * (b[0] - c[0]);
  const double det = left - right;
  if (std::abs(det) > relative_error * (std::abs(left) + std::abs(right)) + absolute_error) return sign(det);
  return coincide(a, b, c) ? 0 : sign(careful_area(a, b, c));
}

double doubled_area(const PlanePoint& a, const PlanePoint& b, const PlanePoint& c) {
  const double left = (a[0] - c[0]) * (b[1] - c[1]), right = (a[1] - c[1]) * (b[0] - c[0]);
  const double det = left - right;
  if (cancellation * std::abs(det) > std::abs(left) + std::abs(right) + absolute_error) return det;
  return coincide(a, b, c) ? 0 : careful_area(a, b, c);
}

}  // namespace isostretch::mesh
