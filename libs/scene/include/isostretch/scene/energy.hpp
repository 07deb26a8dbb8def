#pragma once

#include <isostretch/energies/any_energy.hpp>
#include <isostretch/scene/node.hpp>

#include <optional>

namespace isostretch::scene {

/// Reads "energy" and "material" of a scene or of a region, which has those of `fallback` where it gives
/// none, for a body of that dimension. Throws Error naming the key by its path.
energies::AnyEnergy read_energy(const Node& owner, int dim, const std::optional<Node>& fallback = {});

}  // namespace isostretch::scene
