#include "assembler_kernels.hpp"

#include <isostretch/assembly/energy_assembler.hpp>
#include <isostretch/core/arena.hpp>
#include <isostretch/core/error.hpp>
#include <isostretch/core/to_text.hpp>

#include <omp.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <exception>
#include <limits>
#include <mutex>
#include <numeric>
#include <optional>
#include <string>
#include <utility>

namespace isostretch::assembly {
namespace {

using projection::PointChunk;

std::size_t size(int n) {
  return static_cast<std::size_t>(n);
}

// Scratch of one thread, laid out once.
struct Workspace {
  Workspace(int dim, int nodes)
      : arena(sizeof(double) * (projection::point_chunk_doubles(dim) +
                                size(projection::chunk_size(dim)) *
                                    size(3 * nodes * dim + BlockAssembler::pairs(nodes) * dim * dim + 1) +
                                64)),
        points(projection::bind_point_chunk(dim, arena.doubles(projection::point_chunk_doubles(dim)))) {
    const std::size_t chunk = size(projection::chunk_size(dim));
    X = arena.doubles(chunk * size(nodes * dim));
    DX = arena.doubles(chunk * size(nodes * dim));
    G = arena.doubles(chunk * size(nodes * dim));
    H = arena.doubles(chunk * size(BlockAssembler::pairs(nodes) * dim * dim));
    filtered = arena.doubles(chunk);
  }

  Arena arena;
  PointChunk points;
  double* X;
  double* DX;
  double* G;
  double* H;
  double* filtered;
};

// 1 for the elements with a marked node, 0 for the others.
void mark_elements(const ElementChunk& chunk, int nodes, const unsigned char* marked, double* filtered) {
  for (int i = 0; i < chunk.count; ++i) {
    filtered[i] = 0;
    for (int a = 0; a < nodes; ++a)
      if (marked[chunk.nodes[size(a) * chunk.stride + size(i)]] != 0) filtered[i] = 1;
  }
}

void require_supported(const energies::AnyEnergy& energy, int dim) {
  if (!energy.supports(dim))
    throw Error("energy '" + energy.name() + "' does not exist in " + std::to_string(dim) + "D");
}

}  // namespace

void EnergyAssembler::set_energy(energies::AnyEnergy energy) {
  require_supported(energy, dim_);
  energy_ = std::move(energy);
}

EnergyAssembler::EnergyAssembler(const Elements& elements, energies::AnyEnergy energy)
    : energy_(std::move(energy)),
      dim_(elements.dim),
      nodes_(elements.nodes_per_element),
      points_(elements.points_per_element),
      node_count_(elements.node_count),
      element_count_(elements.element_count()) {
  elements.validate();
  require_supported(energy_, dim_);
  chunk_ = projection::chunk_size(dim_);
  chunk_count_ = (element_count_ + chunk_ - 1) / chunk_;
  order_elements(elements);
  chunk_elements(elements);
}

void EnergyAssembler::set_scale(double scale) {
  if (!(scale > 0) || !std::isfinite(scale))
    throw Error("energies are scaled by positive numbers, not by " + to_text(scale));
  scale_ = scale;
}

// By smallest node: the gather passes walk over nodes, and then read the elements' slots nearly in order.
void EnergyAssembler::order_elements(const Elements& elements) {
  const auto nodes = [&](int e) { return elements.nodes.begin() + static_cast<std::ptrdiff_t>(e) * nodes_; };
  std::vector<int> smallest(size(element_count_));
  for (int e = 0; e < element_count_; ++e) smallest[size(e)] = *std::min_element(nodes(e), nodes(e) + nodes_);
  original_.resize(size(element_count_));
  std::iota(original_.begin(), original_.end(), 0);
  std::stable_sort(original_.begin(), original_.end(),
                   [&](int a, int b) { return smallest[size(a)] < smallest[size(b)]; });
  std::vector<int> ordered;
  ordered.reserve(elements.nodes.size());
  for (const int e : original_) ordered.insert(ordered.end(), nodes(e), nodes(e) + nodes_);
  restriction_ = Restriction(std::move(ordered), nodes_, node_count_);
}

void EnergyAssembler::chunk_elements(const Elements& elements) {
  const std::size_t chunks = size(chunk_count_), lanes = size(chunk_);
  chunk_nodes_.resize(chunks * size(nodes_) * lanes);
  chunk_gradients_.resize(chunks * size(points_ * nodes_ * dim_) * lanes);
  chunk_weights_.resize(chunks * size(points_) * lanes);
  for (std::size_t c = 0; c < chunks; ++c)
    for (std::size_t lane = 0; lane < lanes; ++lane) {
      const std::size_t e = size(original_[std::min(c * lanes + lane, size(element_count_) - 1)]);
      for (std::size_t a = 0; a < size(nodes_); ++a)
        chunk_nodes_[(c * size(nodes_) + a) * lanes + lane] = elements.nodes[e * size(nodes_) + a];
      for (std::size_t p = 0; p < size(points_); ++p) {
        const std::size_t from = e * size(points_) + p, to = c * size(points_) + p;
        chunk_weights_[to * lanes + lane] = elements.weights[from];
        for (std::size_t k = 0; k < size(nodes_ * dim_); ++k)
          chunk_gradients_[(to * size(nodes_ * dim_) + k) * lanes + lane] =
              elements.gradients[from * size(nodes_ * dim_) + k];
      }
    }
}

void EnergyAssembler::set_pattern(const HessianPattern& pattern) {
  blocks_.emplace(restriction_, pattern);
}

namespace {

// Exceptions must not leave a parallel region: the one of the smallest chunk is kept until it is over.
class FirstException {
 public:
  template <class Work>
  void watch(int chunk, const Work& work) noexcept {
    try {
      work();
    } catch (...) {
      const std::lock_guard lock(mutex_);
      if (exception_ && chunk >= chunk_) return;
      exception_ = std::current_exception();
      chunk_ = chunk;
    }
  }
  void rethrow() const {
    if (exception_) std::rethrow_exception(exception_);
  }

 private:
  std::mutex mutex_;
  std::exception_ptr exception_;
  int chunk_ = 0;
};

}  // namespace

// body(kernels, workspace, chunk, point, element chunk) for every quadrature point of every chunk, points of
// one chunk in order on one thread.
template <class Body>
void EnergyAssembler::for_each_chunk(const Body& body) const {
  const ElementKernels& kernels = element_kernels(dim_, nodes_);
  FirstException exception;
#pragma omp parallel
  {
    std::optional<Workspace> work;
    exception.watch(-1, [&] { work.emplace(dim_, nodes_); });
#pragma omp for schedule(dynamic, 4)
    for (int c = 0; c < chunk_count_; ++c)
      if (work) exception.watch(c, [&] { for_each_point(kernels, *work, c, body); });
  }
  exception.rethrow();
}

template <class Kernels, class Work, class Body>
void EnergyAssembler::for_each_point(const Kernels& kernels, Work& work, int c, const Body& body) const {
  const std::size_t lanes = size(chunk_);
  ElementChunk chunk{};
  chunk.real = std::min(chunk_, element_count_ - c * chunk_);
  chunk.count = projection::padded_count(chunk.real);
  chunk.stride = lanes;
  chunk.scale = scale_;
  chunk.nodes = chunk_nodes_.data() + size(c * nodes_) * lanes;
  work.points.count = work.points.stretch.count = chunk.count;
  for (int p = 0; p < points_; ++p) {
    const std::size_t point = size(c) * size(points_) + size(p);
    chunk.gradients = chunk_gradients_.data() + point * size(nodes_ * dim_) * lanes;
    chunk.weights = chunk_weights_.data() + point * lanes;
    body(kernels, work, c, p, chunk);
  }
}

namespace {

// sum of weight * psi over the real points of a chunk, in a fixed order.
double weighted_sum(const ElementChunk& chunk, const PointChunk& points) {
  double sum = 0;
  for (int i = 0; i < chunk.real; ++i) sum += chunk.weights[i] * points.stretch.psi[i];
  return chunk.scale * sum;
}

Evaluation total(const std::vector<double>& chunk_values) {
  Evaluation result;
  for (const double value : chunk_values) result.value += value;
  return result;
}

}  // namespace

Evaluation EnergyAssembler::value(const double* x) {
  chunk_values_.assign(size(chunk_count_), 0.0);
  std::vector<int> worst(size(chunk_count_), -1);
  for_each_chunk(
      [&](const ElementKernels& kernels, Workspace& work, int c, int p, const ElementChunk& chunk) {
        if (p == 0) kernels.gather(chunk, x, work.X);
        kernels.deform(chunk, work.X, work.points, false);
        energy_.evaluate_psi(dim_, work.points.stretch);
        chunk_values_[size(c)] += weighted_sum(chunk, work.points);
        for (int i = 0; i < chunk.real && worst[size(c)] < 0; ++i)
          if (!std::isfinite(work.points.stretch.psi[i])) worst[size(c)] = original_[size(c * chunk_ + i)];
      });
  Evaluation result = total(chunk_values_);
  for (const int element : worst)
    if (element >= 0) {
      result.worst_element = element;
      break;
    }
  if (result.worst_element >= 0) result.value = std::numeric_limits<double>::infinity();
  result.points = point_count();
  return result;
}

Evaluation EnergyAssembler::differentiate(const double* x, const projection::FilterOptions& filter,
                                          double* gradient, bool hessian) {
  const std::size_t per_element = size(nodes_ * dim_), blocks = hessian_entries_per_element();
  gradient_slots_.resize(size(element_count_) * per_element);
  if (hessian) hessian_slots_.resize(size(element_count_) * blocks);
  chunk_values_.assign(size(chunk_count_), 0.0);
  std::vector<int> worst(size(chunk_count_), -1), filtered(size(chunk_count_), 0);
  for_each_chunk([&](const ElementKernels& kernels, Workspace& work, int c, int p, ElementChunk chunk) {
    if (hessian && filter.nodes != nullptr) {
      if (p == 0) mark_elements(chunk, nodes_, filter.nodes, work.filtered);
      chunk.filtered = work.filtered;
    }
    if (p == 0) {
      kernels.gather(chunk, x, work.X);
      std::fill_n(work.G, per_element * chunk.stride, 0.0);
      if (hessian) std::fill_n(work.H, blocks * chunk.stride, 0.0);
    }
    kernels.deform(chunk, work.X, work.points, true);
    energy_.evaluate_derivatives(dim_, work.points.stretch);
    chunk_values_[size(c)] += weighted_sum(chunk, work.points);
    for (int i = 0; i < chunk.real && worst[size(c)] < 0; ++i)
      if (!std::isfinite(work.points.stretch.psi[i])) worst[size(c)] = original_[size(c * chunk_ + i)];
    filtered[size(c)] += kernels.differentiate(chunk, work.points, filter, energy_.coupled(), work.G,
                                               hessian ? work.H : nullptr);
    if (p + 1 < points_) return;
    // Out of the chunk's order into one contiguous slot per element, which the gather pass reads.
    const std::size_t first = size(c * chunk_);
    for (std::size_t i = 0; i < size(chunk.real); ++i) {
      double* g = gradient_slots_.data() + (first + i) * per_element;
      for (std::size_t k = 0; k < per_element; ++k) g[k] = work.G[k * chunk.stride + i];
      if (!hessian) continue;
      double* h = hessian_slots_.data() + (first + i) * blocks;
      for (std::size_t k = 0; k < blocks; ++k) h[k] = work.H[k * chunk.stride + i];
    }
  });
  Evaluation result = total(chunk_values_);
  result.points = point_count();
  for (std::size_t c = 0; c < size(chunk_count_); ++c) {
    result.points_filtered += size(filtered[c]);
    if (worst[c] >= 0 && result.worst_element < 0) result.worst_element = worst[c];
  }
  if (result.worst_element >= 0) {
    result.value = std::numeric_limits<double>::infinity();
    return result;
  }
  if (gradient == nullptr) return result;
  restriction_.add_transposed(dim_, gradient_slots_.data(), gradient);
  return result;
}

std::size_t EnergyAssembler::hessian_entries_per_element() const {
  return size(BlockAssembler::pairs(nodes_) * dim_ * dim_);
}

double* EnergyAssembler::element_hessians() {
  hessian_slots_.resize(size(element_count_) * hessian_entries_per_element());
  return hessian_slots_.data();
}

int EnergyAssembler::element_not_finite() const {
  const auto first_fault = [](const std::vector<double>& slots, std::size_t per_element) {
    const auto fault =
        std::find_if_not(slots.begin(), slots.end(), [](double v) { return std::isfinite(v); });
    return static_cast<std::size_t>(fault - slots.begin()) / per_element;
  };
  const std::size_t first =
      std::min(first_fault(gradient_slots_, size(nodes_ * dim_)),
               hessian_slots_.empty() ? size(element_count_)
                                      : first_fault(hessian_slots_, hessian_entries_per_element()));
  return first < original_.size() ? original_[first] : -1;
}

void EnergyAssembler::add_hessian(double* values) const {
  if (!blocks_) throw Error("add_hessian() before set_pattern()");
  if (hessian_slots_.empty()) throw Error("add_hessian() before differentiate() with a Hessian");
  blocks_->add_stored(hessian_slots_.data(), values);
}

double EnergyAssembler::max_step(const double* x, const double* dx, double limit) const {
  if (!energy_.has_barrier()) return limit;
  const double bound = energy_.determinant_bound();
  std::vector<double> steps(size(chunk_count_), limit);
  for_each_chunk(
      [&](const ElementKernels& kernels, Workspace& work, int c, int p, const ElementChunk& chunk) {
        if (p == 0) {
          kernels.gather(chunk, x, work.X);
          kernels.gather(chunk, dx, work.DX);
        }
        kernels.determinant(chunk, work.X, work.DX, work.points.F);
        for (int i = 0; i < chunk.real; ++i)
          steps[size(c)] = determinant_step(dim_, work.points.F + i, chunk.stride, bound, steps[size(c)]);
      });
  return *std::min_element(steps.begin(), steps.end());
}

std::vector<double> EnergyAssembler::stretches(const double* x) const {
  std::vector<double> sigma(point_count() * size(dim_));
  for_each_chunk(
      [&](const ElementKernels& kernels, Workspace& work, int c, int p, const ElementChunk& chunk) {
        if (p == 0) kernels.gather(chunk, x, work.X);
        kernels.deform(chunk, work.X, work.points, false);
        for (int i = 0; i < chunk.real; ++i)
          for (int d = 0; d < dim_; ++d)
            sigma[(size(original_[size(c * chunk_ + i)]) * size(points_) + size(p)) * size(dim_) + size(d)] =
                work.points.sigma[size(d) * chunk.stride + size(i)];
      });
  return sigma;
}

}  // namespace isostretch::assembly
