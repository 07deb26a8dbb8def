// Nanoseconds per quadrature point of each built-in energy at the active instruction-set level
// (ISOSTRETCH_ISA=base|v2|v3|v4 chooses): psi alone as in a line search, and all derivatives.
#include <isostretch/energies/registry.hpp>

#include <benchmark/benchmark.h>

#include <random>
#include <string>
#include <vector>

namespace {

using namespace isostretch::energies;

// The chunk sizes of assembly; a chunk and its results stay in the first-level cache.
constexpr int points_of(int dim) {
  return dim == 2 ? 64 : 32;
}

class Points {
 public:
  explicit Points(int dim)
      : count_(static_cast<std::size_t>(points_of(dim))), entries_(6 * 3 * count_ + count_) {
    std::mt19937 generator(1);
    std::uniform_real_distribution<double> uniform(0.6, 1.6);
    for (std::size_t i = 0; i < 3 * count_; ++i) entries_[i] = uniform(generator);
    chunk_.count = points_of(dim);
    chunk_.stride = count_;
    chunk_.sigma = array(0);
    chunk_.gradient = array(1);
    chunk_.twist = array(2);
    chunk_.flip = array(3);
    chunk_.diagonal = array(4);
    chunk_.coupling = array(5);
    chunk_.psi = array(6);
  }

  const StretchChunk& chunk() const { return chunk_; }

 private:
  double* array(std::size_t n) { return entries_.data() + n * 3 * count_; }

  std::size_t count_;
  std::vector<double> entries_;
  StretchChunk chunk_;
};

template <class Evaluate>
void run(benchmark::State& state, int dim, Evaluate evaluate) {
  const Points points(dim);
  for (auto _ : state) {
    evaluate(points.chunk());
    benchmark::ClobberMemory();
  }
  const double evaluated = static_cast<double>(state.iterations()) * points_of(dim);
  state.counters["ns_per_point"] =
      benchmark::Counter(evaluated * 1e-9, benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

void add_benchmarks(const std::string& name, int dim) {
  const AnyEnergy energy = make_energy(name);
  if (!energy.supports(dim)) return;
  const std::string suffix = "/" + name + "/" + std::to_string(dim) + "d";
  benchmark::RegisterBenchmark(("psi" + suffix).c_str(), [=](benchmark::State& state) {
    run(state, dim, [&](const StretchChunk& chunk) { energy.evaluate_psi(dim, chunk); });
  });
  benchmark::RegisterBenchmark(("derivatives" + suffix).c_str(), [=](benchmark::State& state) {
    run(state, dim, [&](const StretchChunk& chunk) { energy.evaluate_derivatives(dim, chunk); });
  });
}

}  // namespace

int main(int argc, char** argv) {
  for (const int dim : {2, 3})
    for (const auto& name : energy_names()) add_benchmarks(name, dim);
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  benchmark::RunSpecifiedBenchmarks();
}
