// A chain of springs that is pulled at its end, factorised once and solved for two loads at a time.
#include <isostretch/cholesky/factor.hpp>

#include <cmath>
#include <vector>

int main() {
  using namespace isostretch;
  constexpr int n = 50;
  std::vector<int> start{0}, row;
  std::vector<double> value;
  for (int j = 0; j < n; ++j) {
    row.push_back(j);
    value.push_back(j + 1 < n ? 2.0 : 1.0);
    if (j + 1 < n) {
      row.push_back(j + 1);
      value.push_back(-1.0);
    }
    start.push_back(static_cast<int>(row.size()));
  }
  const cholesky::Analysis analysis({n, start.data(), row.data()});
  cholesky::Factor factor(analysis);
  if (!factor.factorize(value.data())) return 1;
  std::vector<double> x(2 * n, 0.0);
  x[n - 1] = 1.0;
  x[2 * n - 1] = 3.0;
  factor.solve(x.data(), x.data(), 2);
  for (int j = 0; j < n; ++j)
    if (std::abs(x[static_cast<std::size_t>(j)] - (j + 1)) > 1e-10 ||
        std::abs(x[static_cast<std::size_t>(n + j)] - 3 * (j + 1)) > 1e-10)
      return 1;
  return 0;
}
