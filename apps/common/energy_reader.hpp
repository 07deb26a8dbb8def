#pragma once

#include "common/json_value.hpp"

#include <isostretch/energies/any_energy.hpp>

#include <optional>

namespace isostretch::app {

// "energy" and "material" of a scene or of a part of it, which has those of `fallback` where it gives none.
// Throws Error naming the key by its path.
energies::AnyEnergy read_energy(const JsonValue& owner, int dim,
                                const std::optional<JsonValue>& fallback = {});

}  // namespace isostretch::app
