#pragma once

#include <string_view>
#include <vector>

namespace isostretch {

// Instruction-set levels that kernels are compiled for. `base` is plain scalar C++ and runs everywhere; v2,
// v3 and v4 are the x86-64 micro-architecture levels (SSE4.2, AVX2 with FMA, AVX-512) with packs of 2, 4 and
// 8 doubles.
enum class Isa { base, v2, v3, v4 };

inline constexpr int isa_count = 4;

std::string_view isa_name(Isa isa) noexcept;

// Throws Error naming the levels that exist when `name` is none of them.
Isa isa_from_name(std::string_view name);

// Compiled in and supported by this processor and operating system, in ascending order; base is always there.
const std::vector<Isa>& available_isas();

// The level kernels run at: the highest available one, or what the environment variable ISOSTRETCH_ISA asks
// for, or what set_isa() last said. A level that is not available throws Error. Results at different levels
// differ in rounding; at one level they do not depend on the number of threads.
Isa active_isa();
void set_isa(Isa isa);

}  // namespace isostretch
