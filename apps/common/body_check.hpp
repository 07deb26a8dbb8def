#pragma once

#include "common/body.hpp"
#include "common/exit_code.hpp"

#include <functional>
#include <optional>
#include <string>

namespace isostretch::app {

/// What --check finds out about a body.
struct BodyCheck {
  std::string text;          ///< lines for the reader, each ended
  std::string trouble;       ///< why the body cannot be used; empty: it can be
  std::optional<Body> body;  ///< where it can be used
};

/// Looks at a body without stopping at its first fault: kind and number of elements, vertices, box, volume,
/// components, groups, the smallest, the largest and the worst shaped element, and elements that are
/// duplicates, inverted or degenerate. `require` throws Error where the app cannot use the body. Throws Error
/// naming the file where it cannot be read at all.
BodyCheck check_body(const BodySpec& spec, const std::function<void(const Body&)>& require = {});

/// Prints the text and the verdict, and returns the exit code: success, or input for a body in trouble.
ExitCode print_check(const BodyCheck& check);

}  // namespace isostretch::app
