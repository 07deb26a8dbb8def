#include "kernel_table.hpp"

#include <isostretch/core/dispatch.hpp>
#include <isostretch/energies/any_energy.hpp>

#include <string_view>
#include <utility>

#include "builtin_includes.inc"

namespace isostretch::energies {
namespace {

constexpr std::string_view names[] = {
#define ISOSTRETCH_ENERGY(Struct) Struct::name,
#include "builtin_list.inc"
#undef ISOSTRETCH_ENERGY
};
constexpr std::size_t count = std::size(names);
static_assert(count <= builtin_capacity);

}  // namespace

ISOSTRETCH_KERNEL_LEVELS(BuiltinKernels, builtin_kernels)

const std::array<EnergyFunctions, isa_count>* builtin_functions(std::string_view name) {
  static const auto table = [] {
    std::array<std::array<EnergyFunctions, isa_count>, count> all{};
    for (std::size_t i = 0; i < count; ++i)
      for (int level = 0; level < isa_count; ++level)
        if (const BuiltinKernels* kernels = builtin_kernels_at(static_cast<Isa>(level)))
          all[i][static_cast<std::size_t>(level)] = kernels->functions[i];
    return all;
  }();
  for (std::size_t i = 0; i < count; ++i)
    if (names[i] == name) return &table[i];
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
}

}  // namespace isostretch::energies
