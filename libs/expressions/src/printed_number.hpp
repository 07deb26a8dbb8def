#pragma once

#include <string>

namespace isostretch::expressions {

// A ratio; whole numbers are over 1.
struct Fraction {
  double above = 0, below = 1;
};

bool is_whole(double value);

// The shortest decimal text that reads back as the value.
std::string shortest(double value);

// A number as a reader expects it: halves to twelfths as fractions, what is short as it stands, and other
// ratios of whole numbers again as fractions.
Fraction readable(double value);

// Without the last digits that rounding has added to a simple fraction.
double snapped(double value);

}  // namespace isostretch::expressions
