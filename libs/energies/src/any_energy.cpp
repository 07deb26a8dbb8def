#include "kernel_table.hpp"

#include <isostretch/core/dispatch.hpp>
#include <isostretch/energies/any_energy.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string_view>
#include <typeinfo>
#include <utility>

#include "builtin_includes.inc"

namespace isostretch::energies {
namespace {

constexpr std::size_t count = 0
#define ISOSTRETCH_ENERGY(Struct) +1
#include "builtin_list.inc"
#undef ISOSTRETCH_ENERGY
    ;
static_assert(count <= builtin_capacity);

const std::array<const std::type_info*, count>& types() {
  static const std::array<const std::type_info*, count> all = {
#define ISOSTRETCH_ENERGY(Struct) &typeid(Struct),
#include "builtin_list.inc"
#undef ISOSTRETCH_ENERGY
  };
  return all;
}

}  // namespace

ISOSTRETCH_KERNEL_LEVELS(BuiltinKernels, builtin_kernels)

const std::array<EnergyFunctions, isa_count>* builtin_functions(const std::type_info& energy) {
  static const auto table = [] {
    std::array<std::array<EnergyFunctions, isa_count>, count> all{};
    for (std::size_t i = 0; i < count; ++i)
      for (int level = 0; level < isa_count; ++level)
        if (const BuiltinKernels* kernels = builtin_kernels_at(static_cast<Isa>(level)))
          all[i][static_cast<std::size_t>(level)] = kernels->functions[i];
    return all;
  }();
  for (std::size_t i = 0; i < count; ++i)
    if (*types()[i] == energy) return &table[i];
  return nullptr;
}

namespace {

template <int Dim>
void psi_of_object(const void* object, const StretchChunk& chunk) {
  static_cast<const ChunkEnergy*>(object)->psi(Dim, chunk);
}

template <int Dim>
void derivatives_of_object(const void* object, const StretchChunk& chunk) {
  static_cast<const ChunkEnergy*>(object)->derivatives(Dim, chunk);
}

}  // namespace

AnyEnergy::AnyEnergy(std::shared_ptr<const ChunkEnergy> energy)
    : name_(energy->name()),
      determinant_bound_(energy->determinant_bound()),
      coupled_(energy->coupled()),
      parameters_(energy->parameters()) {
  EnergyFunctions functions{};
  if (energy->supports(2))
    functions.psi[0] = psi_of_object<2>, functions.derivatives[0] = derivatives_of_object<2>;
  if (energy->supports(3))
    functions.psi[1] = psi_of_object<3>, functions.derivatives[1] = derivatives_of_object<3>;
  functions_.fill(functions);
  object_ = std::move(energy);
  require_declared_domain();
}

void AnyEnergy::require_declared_domain() const {
  if (has_barrier()) return;
  constexpr int points = 8;  // the least that every kernel takes
  constexpr double inverted[] = {-0.5, -1e-3, -0.9, -0.1, -0.7, -0.3, -1e-6, -1.0};
  for (const int dim : {2, 3}) {
    if (!supports(dim)) continue;
    double sigma[3 * points], psi[points];
    std::fill(std::begin(sigma), std::end(sigma), 1.0);
    std::copy(std::begin(inverted), std::end(inverted), sigma + (dim - 1) * points);
    StretchChunk chunk{};
    chunk.count = chunk.stride = points;
    chunk.sigma = sigma;
    chunk.psi = psi;
    evaluate_psi(dim, chunk);
    if (std::any_of(std::begin(psi), std::end(psi), [](double value) { return std::isnan(value); }))
      throw Error("energy '" + name_ +
                  "' is not a number where the determinant is negative; it must declare minimum_determinant, "
                  "or determinant_bound()");
  }
}

}  // namespace isostretch::energies
