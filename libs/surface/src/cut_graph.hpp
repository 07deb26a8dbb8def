#pragma once

#include "half_edges.hpp"

#include <vector>

namespace isostretch::mesh {

// One connected surface that is to be cut open, and how its edges are measured.
struct Piece {
  HalfEdges surface;
  std::vector<double> weights;          // generic_weights
  std::vector<std::vector<int>> loops;  // half-edges of its boundary loops
  std::vector<double> loop_lengths;     // sums of weights
  int extreme = 0;                      // extreme_vertex
  int genus = 0;
  double area = 0;
};

// Edges whose opening makes a disk of a surface with handles or boundary loops, apart from the loops that are
// kept as holes. A kept loop that the cut cannot avoid is no longer kept on return.
EdgeMarks cut_graph(const Piece& piece, std::vector<char>& kept);

// The same for a closed surface of genus 0: a tree of shortest paths between up to max_terminals vertices.
EdgeMarks cut_tree(const Piece& piece, int max_terminals, double terminal_distance);

// Lengthens a cut to where the surface is curved most, far from it: to tips that would be shrunk or
// stretched. There the logarithm of the scale of a conformal map would be more than `least_scale`. `vertices`
// are those of the piece.
void reach_tips(const Piece& piece, const Points3& vertices, int most, double least_scale, EdgeMarks& marks);

double marked_weight(const HalfEdges& surface, const EdgeMarks& marks, const std::vector<double>& weights);

// For cut_graph: its edges inside the surface, and what they are measured by.
struct CutProblem {
  const HalfEdges& surface;
  // Edges at kept loops are made long, so that the cut keeps away; those of the other loops have length zero.
  std::vector<double> weights;
  std::vector<int> loop_of_half_edge;  // on the boundary; -1 inside
  std::vector<char> kept;              // of loops
  std::vector<char> on_kept_loop;      // of vertices
};

// Takes paths out of the graph and puts the shortest ones in that still open the surface, until that gains
// nothing.
void shorten_cut(const CutProblem& problem, EdgeMarks& graph);

// Unmarks dead ends, edges at a vertex where no other marked edge continues. `vertices` are where to look.
void prune(const HalfEdges& surface, EdgeMarks& marks, std::vector<int> vertices);

}  // namespace isostretch::mesh
