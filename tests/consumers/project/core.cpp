// A pack of doubles at whatever width this file is compiled for, an arena, the version, an Error.
#include "expect.hpp"

#include <isostretch/core/arena.hpp>
#include <isostretch/core/error.hpp>
#include <isostretch/core/isa.hpp>
#include <isostretch/core/pack.hpp>
#include <isostretch/core/version.hpp>

#include <cmath>
#include <string>

int main() {
  isostretch::Arena arena(1024);
  double* values = arena.doubles(isostretch::lanes);
  for (int i = 0; i < isostretch::lanes; ++i) values[i] = 1.0 + i;
  // Vector mathematics: links only if core passes libmvec on to whoever uses packs.
  isostretch::store(values, isostretch::log(isostretch::load<isostretch::Pack>(values)));
  for (int i = 0; i < isostretch::lanes; ++i) EXPECT(std::abs(values[i] - std::log(1.0 + i)) < 1e-14);

  EXPECT(!isostretch::available_isas().empty());
  EXPECT(std::string(isostretch::version_string) == CONSUMER_FOUND_VERSION);
  try {
    isostretch::isa_from_name("abacus");
    EXPECT(false);
  } catch (const isostretch::Error& error) {
    EXPECT(std::string(error.what()).find("abacus") != std::string::npos);
  }
}
