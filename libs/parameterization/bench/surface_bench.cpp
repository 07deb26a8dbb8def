// Checks, Tutte embedding, cutting; files are in io_bench.cpp.
#include <isostretch/fem/element_arrays.hpp>
#include <isostretch/mesh/generators.hpp>
#include <isostretch/parameterization/tutte.hpp>
#include <isostretch/surface/check.hpp>
#include <isostretch/surface/cut.hpp>

#include <benchmark/benchmark.h>

using namespace isostretch::mesh;
using namespace isostretch::parameterization;

namespace {

void count_triangles(benchmark::State& state, const SurfaceMesh& mesh) {
  state.counters["triangles"] = static_cast<double>(mesh.triangles.rows());
}

template <class Work>
void on_face(benchmark::State& state, const Work& work) {
  const SurfaceMesh mesh = procedural_face(static_cast<int>(state.range(0)));
  for (auto _ : state) benchmark::DoNotOptimize(work(mesh));
  count_triangles(state, mesh);
}

void check_face(benchmark::State& state) {
  on_face(state, [](const SurfaceMesh& mesh) { return check(mesh); });
}
void flat_elements_of_face(benchmark::State& state) {
  on_face(state, [](const SurfaceMesh& mesh) { return flat_elements(mesh); });
}
void tutte_of_face(benchmark::State& state) {
  on_face(state, [](const SurfaceMesh& mesh) { return tutte_embedding(mesh); });
}

void tutte_of_grid(benchmark::State& state) {
  const SurfaceMesh mesh = grid(158, 158);  // 50k triangles
  for (auto _ : state) benchmark::DoNotOptimize(tutte_embedding(mesh));
  count_triangles(state, mesh);
}

void cut_sphere(benchmark::State& state) {
  const SurfaceMesh mesh = icosphere(6);
  for (auto _ : state) benchmark::DoNotOptimize(cut_to_disks(mesh));
  count_triangles(state, mesh);
}

}  // namespace

// 93 rings: 52 thousand triangles; 409 rings: a million.
BENCHMARK(check_face)->Arg(93)->Arg(409)->Unit(benchmark::kMillisecond);
BENCHMARK(flat_elements_of_face)->Arg(93)->Arg(409)->Unit(benchmark::kMillisecond);
BENCHMARK(tutte_of_face)->Arg(93)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(tutte_of_grid)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(cut_sphere)->Unit(benchmark::kMillisecond);
BENCHMARK_MAIN();
