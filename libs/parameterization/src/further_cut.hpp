#pragma once

#include <isostretch/parameterization/domain.hpp>

#include <vector>

namespace isostretch::parameterization {

// Largest of sigma_1 and 1 / sigma_2 over triangles, of which `stretches` holds two each; infinite where one
// is turned over.
double worst_distortion(const std::vector<double>& stretches);

// Vertices inside charts (of the opened mesh) from where cuts promise most, best first: in triangles far
// above the bound and far from the boundary, each the only one around.
std::vector<int> worst_vertices(const Domain& domain, const std::vector<double>& stretches, double bound);

// How a cut goes on that ends beside a distorted place: to there, which is short, or two edges straight
// ahead, which looks like a seam and takes fewer rounds.
enum class OnFromEnd { to_vertex, straight };

// A part of a chart with a distorted place in it that a shorter way leads around than to it from the
// boundary, unless it is a mere scrap; triangles ascending, or none.
std::vector<int> part_to_cut_off(const Domain& domain, const std::vector<double>& stretches, double bound);

// Makes a chart of them; uv follows, charts are numbered anew. Returns the chart that each was part of.
std::vector<int> make_apart(Domain& domain, const std::vector<int>& triangles, mesh::Points2& uv);

// Cuts from there to the boundary of its chart; uv follows.
// Returns the chart; -1 and does nothing when an earlier cut has come to the vertex.
int cut_at(Domain& domain, int vertex, OnFromEnd on, mesh::Points2& uv);

// Closes the cut along a path of vertices of the input, as spurs() lists them; uv follows, with the middle of
// what comes together. Charts keep their numbers. Returns the chart that it was in.
int sew(Domain& domain, const std::vector<int>& path, mesh::Points2& uv);

// The most distorted triangle above the bound that has an edge to another one of its chart; -1: none.
int worst_triangle(const Domain& domain, const std::vector<double>& stretches, double bound);

// Cuts along the longest edge inside its chart of a triangle whose corners all lie on the boundary. The chart
// falls into two, unless the edge led from a hole to the outside. uv follows, charts are numbered anew.
// Returns the chart that each was part of.
std::vector<int> cut_off(Domain& domain, int triangle, mesh::Points2& uv);

}  // namespace isostretch::parameterization
