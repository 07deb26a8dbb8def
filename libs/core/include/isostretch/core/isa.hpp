#pragma once

#include <string_view>
#include <vector>

namespace isostretch {

/// The instruction-set levels that kernels are compiled for. `base` is plain scalar C++ and runs everywhere;
/// v2, v3 and v4 are the x86-64 micro-architecture levels (SSE4.2, AVX2 with FMA, AVX-512) with packs of 2, 4
/// and 8 doubles.
enum class Isa { base, v2, v3, v4 };

/// The number of levels in Isa.
inline constexpr int isa_count = 4;

/// Returns the name of the level: "base", "v2", "v3" or "v4".
std::string_view isa_name(Isa isa) noexcept;

/// Returns the level of this name. Throws Error, which names the levels that exist, if there is none.
Isa isa_from_name(std::string_view name);

/// Returns the levels that are compiled in and supported by this processor and operating system, in ascending
/// order. The level base is always there.
const std::vector<Isa>& available_isas();

/// Returns the level that kernels run at: that of the last set_isa(), else that of the environment variable
/// ISOSTRETCH_ISA, else the highest available one. Throws Error if the environment asks for a level that is
/// not available. Results at different levels differ in rounding; at one level they do not depend on the
/// number of threads.
Isa active_isa();
/// Makes kernels run at this level from now on. Throws Error if the level is not available.
void set_isa(Isa isa);

}  // namespace isostretch
