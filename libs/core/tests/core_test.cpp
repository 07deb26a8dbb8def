#include <isostretch/core/arena.hpp>
#include <isostretch/core/atomic_file.hpp>
#include <isostretch/core/error.hpp>
#include <isostretch/core/isa.hpp>
#include <isostretch/core/log.hpp>
#include <isostretch/core/numbers.hpp>
#include <isostretch/core/output_folder.hpp>
#include <isostretch/core/to_text.hpp>
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

TEST_CASE("numbers are taken whole or not at all") {
  CHECK(finite_number("-1.5e3") == -1500);
  CHECK(finite_number("+2") == 2);
  for (const char* text : {"", "1x", " 1", "nan", "inf", "1e400", "+-1", "0x10", "1,5"})
    CHECK_MESSAGE(!finite_number(text), text);
  CHECK(whole_number("12") == 12);
  for (const char* text : {"", "1.0", "99999999999", "1e3"}) CHECK_MESSAGE(!whole_number(text), text);
  CHECK(split("a,,b", ',') == std::vector<std::string>{"a", "", "b"});
  CHECK(std::stod(to_text(0.1 + 0.2)) == 0.1 + 0.2);
}

TEST_CASE("an output folder is filled at once or not at all") {
  const fs::path scratch = fs::temp_directory_path() / ("isostretch_folder_" + std::to_string(::getpid()));
  {
    OutputFolder folder(scratch / "b");
    folder.add("one", "text");
  }
  CHECK_FALSE(fs::exists(scratch));
  OutputFolder folder(scratch / "b/");
  folder.add("one", "text");
  CHECK_FALSE(fs::exists(scratch / "b/one"));
  folder.commit();
  CHECK(fs::file_size(scratch / "b/one") == 4);
  CHECK(folder.paths() == std::vector<fs::path>{scratch / "b/one"});
  {
    OutputFolder other(scratch / "c");
    other.write_now("two", "at once");
    other.add("three", "never");
  }
  CHECK(fs::exists(scratch / "c/two"));
  CHECK_FALSE(fs::exists(scratch / "c/three"));
  CHECK_THROWS_WITH_AS(OutputFolder(scratch / "b/one"), doctest::Contains("is not a folder"), Error);
  fs::remove_all(scratch);
}
