#include <isostretch/core/error.hpp>
#include <isostretch/fem/element_arrays.hpp>
#include <isostretch/handles/weights_cache.hpp>
#include <isostretch/mesh/generators.hpp>

#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include <unistd.h>

using namespace isostretch;
using namespace isostretch::handles;

namespace {

// A folder that is gone when the test ends.
struct Folder {
  std::filesystem::path path =
      std::filesystem::temp_directory_path() / ("isostretch_weights_" + std::to_string(::getpid()));
  Folder() { std::filesystem::remove_all(path); }
  ~Folder() { std::filesystem::remove_all(path); }
};

assembly::Elements bar(double length = 4) {
  return assembly::elements_from(mesh::elements(mesh::tet_bar(6, 2, 2, length, 1, 1)));
}

const std::vector<std::vector<int>> ends{{0, 7, 14}, {6, 13, 20}, {31}};

std::string read(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

void write(const std::filesystem::path& file, const std::string& text) {
  std::ofstream(file, std::ios::binary) << text;
}

void check_same(const HandleWeights& a, const HandleWeights& b) {
  CHECK(a.handles == b.handles);
  CHECK(a.values == b.values);
  CHECK(a.unreached == b.unreached);
  REQUIRE(a.reports.size() == b.reports.size());
  for (std::size_t h = 0; h < a.reports.size(); ++h) {
    CHECK(a.reports[h].iterations == b.reports[h].iterations);
    CHECK(a.reports[h].factorizations == b.reports[h].factorizations);
    CHECK(a.reports[h].at_zero == b.reports[h].at_zero);
    CHECK(a.reports[h].kkt_residual == b.reports[h].kkt_residual);
  }
}

}  // namespace

TEST_CASE("weights are computed once and read from then on, to the bit") {
  const Folder folder;
  const CachedWeights first = cached_weights(folder.path / "deeper", bar(), ends);
  CHECK(!first.hit);
  const CachedWeights second = cached_weights(folder.path / "deeper", bar(), ends);
  CHECK(second.hit);
  CHECK(second.file == first.file);
  check_same(first.weights, second.weights);
  check_same(first.weights, bounded_biharmonic_weights(bar(), ends));
  // Repeated nodes, and their order, make no other handle.
  CHECK(cached_weights(folder.path / "deeper", bar(), {{14, 7, 0, 7}, {6, 13, 20}, {31}}).hit);
}

TEST_CASE("other handles, meshes and tolerances are kept apart") {
  const Folder folder;
  cached_weights(folder.path, bar(), ends);
  CHECK(!cached_weights(folder.path, bar(), {{0, 7, 14}, {6, 13, 20}, {32}}).hit);
  CHECK(!cached_weights(folder.path, bar(), {{0, 7}, {14, 6, 13, 20}, {31}}).hit);
  CHECK(!cached_weights(folder.path, bar(4.5), ends).hit);
  WeightOptions options;
  options.tolerance = 1e-8;
  CHECK(!cached_weights(folder.path, bar(), ends, options).hit);
  CHECK(cached_weights(folder.path, bar(), ends).hit);
}

TEST_CASE("a file that is damaged, cut short or another's is replaced") {
  const Folder folder;
  const CachedWeights good = cached_weights(folder.path, bar(), ends);
  const std::string text = read(good.file);
  REQUIRE(text.size() > 1000);
  std::vector<std::string> bad{
      "",        "x", text.substr(0, text.size() - 1), text.substr(0, text.size() / 2), text.substr(0, 30),
      text + "x"};
  for (const std::size_t place : {std::size_t{0}, std::size_t{25}, text.size() / 2, text.size() - 3}) {
    bad.push_back(text);
    bad.back()[place] = static_cast<char>(bad.back()[place] ^ 4);
  }
  const CachedWeights other = cached_weights(folder.path, bar(5), ends);
  bad.push_back(read(other.file));
  for (const std::string& content : bad) {
    write(good.file, content);
    const CachedWeights again = cached_weights(folder.path, bar(), ends);
    CHECK(!again.hit);
    check_same(again.weights, good.weights);
    CHECK(read(good.file) == text);
  }
}

TEST_CASE("a folder that cannot be written to is named, and invalid input leaves nothing behind") {
  const Folder folder;
  std::filesystem::create_directories(folder.path);
  const auto file = folder.path / "a file";
  write(file, "not a folder");
  CHECK_THROWS_WITH_AS(cached_weights(file, bar(), ends), doctest::Contains("a file"), Error);
  CHECK_THROWS_WITH_AS(cached_weights(file / "below", bar(), ends), doctest::Contains("a file/below"), Error);
  std::filesystem::remove(file);
  CHECK_THROWS_AS(cached_weights(folder.path, bar(), {{0}, {0}}), Error);
  CHECK(std::filesystem::is_empty(folder.path));
}
