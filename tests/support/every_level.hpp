#pragma once

#include <isostretch/core/isa.hpp>

#include <doctest/doctest.h>

#include <type_traits>

namespace isostretch::tests {

// Runs check() or check(level) at every instruction-set level that this machine has.
template <class Check>
void at_every_level(const Check& check) {
  const Isa before = active_isa();
  for (const Isa isa : available_isas()) {
    CAPTURE(isa_name(isa));
    set_isa(isa);
    if constexpr (std::is_invocable_v<Check, Isa>)
      check(isa);
    else
      check();
  }
  set_isa(before);
}

}  // namespace isostretch::tests
