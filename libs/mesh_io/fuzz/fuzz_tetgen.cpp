#include "fuzz_reader.hpp"

#include <string>

// Both files, one behind the other: a line of three dots divides them.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace isostretch::mesh;
  const auto parse = [](std::string_view contents, const std::string& name, const ReadOptions& options) {
    const std::size_t end = contents.find("...");
    const std::string_view rest =
        end == std::string_view::npos ? std::string_view() : contents.substr(end + 3);
    return parse_tetgen_elements({contents.substr(0, end), name, rest, name}, options);
  };
  fuzz::read_elements(data, size, parse);
  return 0;
}
