// Cases for support_test.py, which runs them one by one, with outside data and without.
#include "conditional.hpp"

#include <filesystem>

using isostretch::tests::outside_data;
using isostretch::tests::outside_path;

TEST_CASE("passes") {
  CHECK(true);
}

TEST_CASE("fails; as it should") {
  CHECK(false);
}

TEST_CASE("reads, and passes" * outside_data({"folder/there.txt"})) {
  CHECK(std::filesystem::exists(outside_path("folder/there.txt")));
}

TEST_CASE("reads two files" * outside_data({"folder/there.txt", "other.txt"})) {
  CHECK(std::filesystem::exists(outside_path("other.txt")));
}
