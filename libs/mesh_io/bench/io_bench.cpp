// Parsing and formatting every file format in memory: a surface of a million triangles, and a bar of as many
// tetrahedra.
#include <isostretch/mesh/generators.hpp>
#include <isostretch/mesh_io/io.hpp>

#include <benchmark/benchmark.h>

#include <cstdint>
#include <cstring>
#include <string>

using namespace isostretch::mesh;

namespace {

const SurfaceMesh& face() {
  static const SurfaceMesh mesh = procedural_face(409);
  return mesh;
}

const TetMesh& bar() {
  static const TetMesh mesh = tet_bar(55, 55, 55);
  return mesh;
}

constexpr WriteOptions text = {Encoding::text};
constexpr WriteOptions binary = {Encoding::binary};
constexpr WriteOptions base64 = {Encoding::binary, MshVersion::v4_1, true};
constexpr WriteOptions text_2_2 = {Encoding::text, MshVersion::v2_2};
constexpr WriteOptions binary_2_2 = {Encoding::binary, MshVersion::v2_2};
constexpr WriteOptions text_4_0 = {Encoding::text, MshVersion::v4_0};
constexpr WriteOptions binary_4_0 = {Encoding::binary, MshVersion::v4_0};

std::string binary_stl(const SurfaceMesh& mesh) {
  std::string contents(84 + 50 * static_cast<std::size_t>(mesh.triangles.rows()), '\0');
  const auto count = static_cast<std::uint32_t>(mesh.triangles.rows());
  std::memcpy(&contents[80], &count, sizeof count);
  char* at = &contents[84];
  for (Eigen::Index t = 0; t < mesh.triangles.rows(); ++t, at += 50)
    for (int i = 0; i < 9; ++i) {
      const auto value = static_cast<float>(mesh.vertices(mesh.triangles(t, i / 3), i % 3));
      std::memcpy(at + 12 + 4 * i, &value, sizeof value);
    }
  return contents;
}

void count_bytes(benchmark::State& state, std::size_t bytes) {
  state.SetBytesProcessed(static_cast<std::int64_t>(static_cast<std::size_t>(state.iterations()) * bytes));
  state.counters["MB"] = static_cast<double>(bytes) * 1e-6;
}

template <class Format, class Parse>
void parse(benchmark::State& state, const Format& format, const Parse& parse_contents) {
  const std::string contents = format();
  for (auto _ : state) benchmark::DoNotOptimize(parse_contents(contents, "bench", ReadOptions()));
  count_bytes(state, contents.size());
}

template <class Format>
void format(benchmark::State& state, const Format& make) {
  std::size_t size = 0;
  for (auto _ : state) size = make().size();
  count_bytes(state, size);
}

}  // namespace

#define ISOSTRETCH_BENCH(name, contents, parser)                                           \
  BENCHMARK_CAPTURE(format, name, [] { return contents; })->Unit(benchmark::kMillisecond); \
  BENCHMARK_CAPTURE(                                                                       \
      parse, name, [] { return contents; }, parser)                                        \
      ->Unit(benchmark::kMillisecond)

ISOSTRETCH_BENCH(obj, format_obj(face()), parse_obj);
ISOSTRETCH_BENCH(off, format_off(face()), parse_off);
ISOSTRETCH_BENCH(ply_text, format_ply(face(), text), parse_ply);
ISOSTRETCH_BENCH(ply_binary, format_ply(face(), binary), parse_ply);
ISOSTRETCH_BENCH(stl_binary, binary_stl(face()), parse_stl);
ISOSTRETCH_BENCH(msh_2_2_text, format_msh(face(), text_2_2), parse_msh_surface);
ISOSTRETCH_BENCH(msh_2_2_binary, format_msh(face(), binary_2_2), parse_msh_surface);
ISOSTRETCH_BENCH(msh_4_0_text, format_msh(face(), text_4_0), parse_msh_surface);
ISOSTRETCH_BENCH(msh_4_0_binary, format_msh(face(), binary_4_0), parse_msh_surface);
ISOSTRETCH_BENCH(msh_4_1_text, format_msh(face(), text), parse_msh_surface);
ISOSTRETCH_BENCH(msh_4_1_binary, format_msh(face(), binary), parse_msh_surface);
ISOSTRETCH_BENCH(medit, format_medit(face()), parse_medit_surface);
ISOSTRETCH_BENCH(vtk_text, format_vtk(face(), text), parse_vtk_surface);
ISOSTRETCH_BENCH(vtk_binary, format_vtk(face(), binary), parse_vtk_surface);
ISOSTRETCH_BENCH(vtu_text, format_vtu(face(), text), parse_vtu_surface);
ISOSTRETCH_BENCH(vtu_base64, format_vtu(face(), base64), parse_vtu_surface);
ISOSTRETCH_BENCH(vtu_appended, format_vtu(face(), binary), parse_vtu_surface);
ISOSTRETCH_BENCH(tets_msh_text, format_msh(bar(), text), parse_msh_tets);
ISOSTRETCH_BENCH(tets_msh_binary, format_msh(bar(), binary), parse_msh_tets);
ISOSTRETCH_BENCH(tets_medit, format_medit(bar()), parse_medit_tets);
ISOSTRETCH_BENCH(tets_vtk_binary, format_vtk(bar(), binary), parse_vtk_tets);
ISOSTRETCH_BENCH(tets_vtu_appended, format_vtu(bar(), binary), parse_vtu_tets);
BENCHMARK_CAPTURE(format, glb, [] { return format_glb(face()); })->Unit(benchmark::kMillisecond);
