#pragma once

#include <cstdio>
#include <cstdlib>

// Ends the program with the line at fault: a consumer is a program of its own, without a test framework.
#define EXPECT(condition)                                                  \
  do {                                                                     \
    if (!(condition)) {                                                    \
      std::fprintf(stderr, "%s:%d: %s\n", __FILE__, __LINE__, #condition); \
      std::exit(1);                                                        \
    }                                                                      \
  } while (false)
