#include <isostretch/assembly/deformation_operator.hpp>

namespace isostretch::assembly {
namespace {

template <int Dim>
void fill_gradients(const Elements& elements, const double* x, std::size_t first, std::size_t count,
                    double* F, std::size_t stride) {
  const DeformationOperator<Dim> deformation(elements);
  for (std::size_t i = 0; i < count; ++i) {
    const linalg::Mat<Dim> Fi = deformation.apply(first + i, x);
    for (int c = 0; c < Dim; ++c)
      for (int r = 0; r < Dim; ++r) F[static_cast<std::size_t>(r + Dim * c) * stride + i] = Fi[r][c];
  }
}

template <int Dim>
std::vector<double> all_determinants(const Elements& elements, const double* x) {
  const DeformationOperator<Dim> deformation(elements);
  std::vector<double> result(elements.weights.size());
  for (std::size_t i = 0; i < result.size(); ++i) result[i] = linalg::determinant(deformation.apply(i, x));
  return result;
}

}  // namespace

void deformation_gradients(const Elements& elements, const double* x, std::size_t first, std::size_t count,
                           double* F, std::size_t stride) {
  if (elements.dim == 2)
    fill_gradients<2>(elements, x, first, count, F, stride);
  else
    fill_gradients<3>(elements, x, first, count, F, stride);
}

std::vector<double> determinants(const Elements& elements, const double* x) {
  return elements.dim == 2 ? all_determinants<2>(elements, x) : all_determinants<3>(elements, x);
}

}  // namespace isostretch::assembly
