#include "machine_peaks.hpp"

#include "json_line.hpp"
#include "peak_table.hpp"
#include "threads.hpp"

#include <isostretch/core/dispatch.hpp>
#include <isostretch/core/timer.hpp>

#include <algorithm>
#include <memory>

namespace isostretch::sparse::bench {

ISOSTRETCH_KERNEL_LEVELS(PeakTable, table)

namespace {

constexpr int attempts = 25;  // of which the best counts: whatever disturbs a machine makes it slower

template <class Work>
double best_seconds(const Work& work) {
  double best = 1e300;
  for (int attempt = 0; attempt < attempts; ++attempt) {
    const Timer timer;
    work();
    best = std::min(best, timer.seconds());
  }
  return best;
}

double operations_per_second(const PeakTable& kernels, int threads) {
  const long rounds = 10'000'000;
  double sum = 0;
  const double seconds = best_seconds([&] {
#pragma omp parallel num_threads(threads) reduction(+ : sum)
    sum += kernels.multiply_add(rounds);
  });
  if (sum == 0) return 0;  // never: the sums are wanted
  return threads * static_cast<double>(rounds) * kernels.operations / seconds;
}

// STREAM's triad a = b + s c on arrays beyond the caches. As there, the lines of `a` that are read before
// they are written do not count.
double bytes_per_second(int threads) {
  const long count = 1L << 24;
  const auto a = std::make_unique_for_overwrite<double[]>(count),
             b = std::make_unique_for_overwrite<double[]>(count),
             c = std::make_unique_for_overwrite<double[]>(count);
#pragma omp parallel for num_threads(threads)
  for (long i = 0; i < count; ++i) a[i] = b[i] = c[i] = 1;
  const double seconds = best_seconds([&] {
#pragma omp parallel for num_threads(threads)
    for (long i = 0; i < count; ++i) a[i] = b[i] + 3 * c[i];
  });
  return 3.0 * sizeof(double) * static_cast<double>(count) / seconds;
}

}  // namespace

std::vector<std::string> machine_peaks() {
  std::vector<std::string> lines;
  JsonLine compiler;
  compiler.add("compiler", std::string(ISOSTRETCH_BENCH_COMPILER));
  lines.push_back(compiler.text());
  std::vector<int> counts{1};
  if (available_threads() > 1) counts.push_back(available_threads());
  for (const int threads : counts) {
    for (const Isa isa : available_isas()) {
      JsonLine line;
      line.add("level", std::string(isa_name(isa)));
      line.add("threads", threads);
      line.add("operations_per_second", operations_per_second(*table_at(isa), threads));
      lines.push_back(line.text());
    }
    JsonLine line;
    line.add("threads", threads);
    line.add("bytes_per_second", bytes_per_second(threads));
    lines.push_back(line.text());
  }
  return lines;
}

}  // namespace isostretch::sparse::bench
