#include <isostretch/assembly/block_assembler.hpp>
#include <isostretch/assembly/operators.hpp>

#include <cstddef>
#include <utility>

namespace isostretch::assembly::operators {
namespace {

double dot(const double* a, const double* b, int dim) {
  double sum = 0;
  for (int i = 0; i < dim; ++i) sum += a[i] * b[i];
  return sum;
}

// w g_a . g_b of every element and pair a <= b, summed over its points.
std::vector<double> element_laplacians(const Elements& elements) {
  const int k = elements.nodes_per_element, dim = elements.dim;
  const auto points = static_cast<std::size_t>(elements.points_per_element);
  std::vector<double> blocks;
  blocks.reserve(static_cast<std::size_t>(elements.element_count()) *
                 static_cast<std::size_t>(BlockAssembler::pairs(k)));
  for (std::size_t first = 0; first < elements.weights.size(); first += points)
    for (int a = 0; a < k; ++a)
      for (int b = a; b < k; ++b) {
        double sum = 0;
        for (std::size_t point = first; point < first + points; ++point) {
          const double* g = elements.gradients.data() + point * static_cast<std::size_t>(k * dim);
          sum += elements.weights[point] * dot(g + a * dim, g + b * dim, dim);
        }
        blocks.push_back(sum);
      }
  return blocks;
}

}  // namespace

sparse::SymmetricMatrix laplacian(const Elements& elements, const FreeUnknowns& nodes) {
  const Restriction restriction(elements);
  PatternBuilder builder(elements.node_count);
  restriction.add_stencil(builder);
  const HessianPattern pattern(nodes, std::move(builder));
  sparse::SymmetricMatrix matrix = pattern.zero_matrix();
  matrix.group.clear();  // every unknown is a node
  BlockAssembler(restriction, pattern).add_stored(element_laplacians(elements).data(), matrix.value.data());
  return matrix;
}

sparse::SymmetricMatrix laplacian(const Elements& elements) {
  return laplacian(elements, FreeUnknowns(1, elements.node_count));
}

std::vector<double> lumped_mass(const Elements& elements) {
  std::vector<double> mass(static_cast<std::size_t>(elements.node_count), 0.0);
  const auto k = static_cast<std::size_t>(elements.nodes_per_element),
             points = static_cast<std::size_t>(elements.points_per_element);
  for (std::size_t i = 0; i < elements.nodes.size(); ++i)
    for (std::size_t p = 0; p < points; ++p)
      mass[static_cast<std::size_t>(elements.nodes[i])] +=
          elements.weights[i / k * points + p] / static_cast<double>(k);
  return mass;
}

}  // namespace isostretch::assembly::operators
