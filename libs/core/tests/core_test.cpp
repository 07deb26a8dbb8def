#include <isostretch/core/arena.hpp>
#include <isostretch/core/atomic_file.hpp>
#include <isostretch/core/error.hpp>
#include <isostretch/core/isa.hpp>
#include <isostretch/core/log.hpp>
#include <isostretch/core/version.hpp>

#include <doctest/doctest.h>

#include <unistd.h>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

using namespace isostretch;
namespace fs = std::filesystem;

TEST_CASE("instruction-set levels: base is always there, unknown and missing ones are refused by name") {
  CHECK(available_isas().front() == Isa::base);
  const Isa before = active_isa();
  for (const Isa isa : available_isas()) {
    set_isa(isa);
    CHECK(active_isa() == isa);
    CHECK(isa_from_name(isa_name(isa)) == isa);
  }
  set_isa(before);
  CHECK_THROWS_WITH_AS(isa_from_name("avx9"), doctest::Contains("base, v2, v3, v4"), Error);
}

TEST_CASE("log: silent without a sink, and the previous sink comes back") {
  CHECK_FALSE(log_enabled(LogLevel::error));
  log(LogLevel::error, "nobody hears this");
  std::vector<std::string> heard;
  set_log_sink([&](LogLevel, std::string_view message) { heard.emplace_back(message); });
  CHECK(log_enabled(LogLevel::trace));
  log(LogLevel::info, "hello");
  const LogSink previous = set_log_sink({});
  CHECK(static_cast<bool>(previous));
  log(LogLevel::info, "again nobody");
  CHECK(heard == std::vector<std::string>{"hello"});
}

TEST_CASE("arena: aligned blocks, reuse after reset, refusal beyond its capacity") {
  Arena arena(1024);
  double* a = arena.doubles(3);
  double* b = arena.doubles(8);
  CHECK(reinterpret_cast<std::uintptr_t>(a) % 64 == 0);
  CHECK(b - a == 8);
  CHECK_THROWS_AS(arena.doubles(1000), Error);
  arena.reset();
  CHECK(arena.doubles(128) == a);
}

TEST_CASE("atomic file: complete under its name after commit, nothing without it") {
  const fs::path folder =
      fs::temp_directory_path() / ("isostretch_atomic_test_" + std::to_string(::getpid()));
  fs::remove_all(folder);
  fs::create_directories(folder);
  const std::string path = (folder / "out.txt").string();
  {
    AtomicFile file(path);
    file.write("half");
  }
  CHECK(fs::is_empty(folder));
  {
    AtomicFile file(path);
    file.write("whole");
    file.commit();
  }
  std::ifstream in(path);
  std::string text;
  in >> text;
  CHECK(text == "whole");
  CHECK(std::distance(fs::directory_iterator(folder), fs::directory_iterator()) == 1);
  CHECK_THROWS_WITH_AS(AtomicFile((folder / "missing" / "x").string()), doctest::Contains("missing/x"),
                       Error);
  CHECK_THROWS_WITH_AS(AtomicFile(folder.string()), doctest::Contains("directory"), Error);
  fs::remove_all(folder);
}

TEST_CASE("atomic file: a full disk is an error, not a short file") {
  if (!fs::exists("/dev/full")) return;
  // Writing beside /dev/full is not possible for everybody; the device itself cannot be renamed onto either.
  CHECK_THROWS_AS(
      [] {
        AtomicFile file("/dev/full/x");
        file.commit();
      }(),
      Error);
}

TEST_CASE("version: one string, made of its parts") {
  CHECK(std::string(version_string) == std::to_string(version_major) + "." + std::to_string(version_minor) +
                                           "." + std::to_string(version_patch));
}
