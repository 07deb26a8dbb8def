#pragma once

#include <isostretch/core/option_fields.hpp>

namespace isostretch::scene {

/// The limits of every run of a method in a comparison. is allowed in a comparison.
struct ComparisonLimits {
  double gradient_tolerance = 1e-4;  ///< largest component of the gradient, with a rest of area or volume 1
  /// The largest number of iterations of a run.
  int max_iterations = 1000;
  double time_limit = 60;   ///< seconds; 0: none
  double memory_limit = 0;  ///< megabytes; 0: none

  /// Visits (Field, member) for each option, see core/option_fields.hpp.
  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    visit(Field{"gradient_tolerance", "A run ends at |gradient|_inf <= this, with a rest of area or volume 1",
                at_least(0)},
          self.gradient_tolerance);
    visit(Field{"max_iterations", "Iterations of a run", between(0, 1e9)}, self.max_iterations);
    visit(Field{"time_limit", "Time of a run; 0: no limit", at_least(0), "seconds"}, self.time_limit);
    visit(Field{"memory_limit", "Memory of the process of a run, at least 256; 0: no limit", at_least(0),
                "megabytes"},
          self.memory_limit);
  }
};

}  // namespace isostretch::scene
