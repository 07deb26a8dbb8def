#define DOCTEST_CONFIG_IMPLEMENT
#include "conditional.hpp"

int main(int argc, char** argv) {
  doctest::Context context(argc, argv);
  const int result = context.run();
  return result == 0 && isostretch::tests::skipped_cases() > 0 ? isostretch::tests::skip_code : result;
}
