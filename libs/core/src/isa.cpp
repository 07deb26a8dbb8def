#include <isostretch/core/error.hpp>
#include <isostretch/core/isa.hpp>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdlib>
#include <string>

#if defined(ISOSTRETCH_HAS_ISA_LEVELS)
#include <cpuid.h>
#endif

namespace isostretch {
namespace {

constexpr std::array<std::string_view, isa_count> names = {"base", "v2", "v3", "v4"};

#if defined(ISOSTRETCH_HAS_ISA_LEVELS)
// -march=x86-64-v3 lets the compiler use all of the level, so all of it is asked for, not only AVX2.
bool has_v2_baseline() {
  return __builtin_cpu_supports("sse4.2") && __builtin_cpu_supports("ssse3") &&
         __builtin_cpu_supports("popcnt");
}

bool has_v3_baseline() {
  unsigned a = 0, b = 0, c = 0, d = 0;
  if (!has_v2_baseline() || !__builtin_cpu_supports("avx2") || !__builtin_cpu_supports("fma") ||
      !__builtin_cpu_supports("bmi") || !__builtin_cpu_supports("bmi2"))
    return false;
  if (!__get_cpuid(1, &a, &b, &c, &d) || !(c & bit_MOVBE) || !(c & bit_F16C)) return false;
  return __get_cpuid(0x80000001, &a, &b, &c, &d) && (c & bit_LZCNT);
}

bool has_v4_baseline() {
  return has_v3_baseline() && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw") &&
         __builtin_cpu_supports("avx512cd") && __builtin_cpu_supports("avx512dq") &&
         __builtin_cpu_supports("avx512vl");
}
#endif

std::vector<Isa> detect() {
  std::vector<Isa> levels = {Isa::base};
#if defined(ISOSTRETCH_HAS_ISA_LEVELS)
  if (has_v2_baseline()) levels.push_back(Isa::v2);
  if (has_v3_baseline()) levels.push_back(Isa::v3);
  if (has_v4_baseline()) levels.push_back(Isa::v4);
#endif
  return levels;
}

std::string join_available() {
  std::string text;
  for (const Isa isa : available_isas()) text += (text.empty() ? "" : ", ") + std::string(isa_name(isa));
  return text;
}

void require_available(Isa isa) {
  const auto& levels = available_isas();
  if (std::find(levels.begin(), levels.end(), isa) == levels.end())
    throw Error("instruction-set level '" + std::string(isa_name(isa)) +
                "' is not available here; available: " + join_available());
}

Isa initial_isa() {
  const char* wanted = std::getenv("ISOSTRETCH_ISA");
  if (wanted == nullptr || *wanted == '\0') return available_isas().back();
  const Isa isa = isa_from_name(wanted);
  require_available(isa);
  return isa;
}

std::atomic<Isa>& current_isa() {
  static std::atomic<Isa> isa{initial_isa()};
  return isa;
}

}  // namespace

std::string_view isa_name(Isa isa) noexcept {
  return names[static_cast<std::size_t>(isa)];
}

Isa isa_from_name(std::string_view name) {
  for (std::size_t i = 0; i < names.size(); ++i)
    if (names[i] == name) return static_cast<Isa>(i);
  throw Error("unknown instruction-set level '" + std::string(name) + "'; there are base, v2, v3, v4");
}

const std::vector<Isa>& available_isas() {
  static const std::vector<Isa> levels = detect();
  return levels;
}

Isa active_isa() {
  return current_isa().load(std::memory_order_relaxed);
}

void set_isa(Isa isa) {
  require_available(isa);
  current_isa().store(isa);
}

}  // namespace isostretch
