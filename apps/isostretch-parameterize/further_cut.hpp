#pragma once

#include "domain.hpp"

#include <vector>

namespace isostretch::app::parameterize {

// Largest of sigma_1 and 1 / sigma_2 over triangles, of which `stretches` holds two each; infinite where one is
// turned over.
double worst_distortion(const std::vector<double>& stretches);

// A vertex inside a chart (of the opened mesh) in the most distorted triangle above the bound that has one; -1: none.
int worst_vertex(const Domain& domain, const std::vector<double>& stretches, double bound);

// Cuts from there to the boundary of its chart; uv follows. Returns the chart.
int cut_at(Domain& domain, int vertex, mesh::Points2& uv);

}  // namespace isostretch::app::parameterize
