#pragma once

#include <isostretch/deformation/solid_model.hpp>

#include <functional>
#include <optional>
#include <string>

namespace isostretch::deformation {

/// The findings of check_solid() about a body.
struct SolidCheck {
  std::string text;                ///< Lines for the reader, each ended.
  std::string trouble;             ///< Reason why the body cannot be used; empty where it can be.
  std::optional<SolidModel> body;  ///< The body, where it can be used.
};

/// Checks a body without stopping at its first fault: kind and number of elements, vertices, box, volume,
/// components, groups, the smallest, the largest and the worst shaped element, and elements that are
/// duplicates, inverted or degenerate. `require` throws Error where the app cannot use the body. Throws Error
/// naming the file where it cannot be read at all.
SolidCheck check_solid(const SolidSpec& spec, const std::function<void(const SolidModel&)>& require = {});

}  // namespace isostretch::deformation
