#pragma once

#include <isostretch/sparse/solver.hpp>

#include <doctest/doctest.h>

#include <string>

namespace isostretch::sparse::test {

// Calls body(options) for every back end with every ordering it can have.
template <class Body>
void for_each_solver(const Body& body) {
  for (const Backend backend : available_backends())
    for (const Ordering ordering : available_orderings()) {
      Options options;
      options.backend = backend;
      options.ordering = ordering;
      options.pcg_tolerance = 1e-11;
      const std::string backend_text(backend_name(backend)), ordering_text(ordering_name(ordering));
      CAPTURE(backend_text);
      CAPTURE(ordering_text);
      body(options);
    }
}

}  // namespace isostretch::sparse::test
