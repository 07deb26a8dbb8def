#include "model_picture.hpp"

#include "checker_square.hpp"

#include <isostretch/core/text.hpp>
#include <isostretch/figures/model_figure.hpp>
#include <isostretch/surface/seams.hpp>

namespace isostretch::app::parameterize {
namespace {

// Where the surface is cut, and where it ends.
std::vector<std::array<int, 2>> outlines(const Domain& domain) {
  std::vector<std::array<int, 2>> lines = mesh::edges_of(domain.input.triangles).boundary;
  for (const mesh::Edge& edge : domain.cut.seams) lines.push_back({edge.low, edge.high});
  return lines;
}

std::string subtitle(const Result& r, double square) {
  std::string text = formatted("squares of side %.3g where lengths are kept, in units of the model",
                               square / r.layout.scale);
  if (!r.domain.cut.seams.empty())
    text += formatted("   ·   seams: %zu edges, length %.3g", r.domain.cut.seams.size(),
                      mesh::seam_length(r.domain.input.vertices, r.domain.cut.seams));
  if (!r.layout.flipped.empty()) text += formatted("   ·   %zu flipped (blue)", r.layout.flipped.size());
  return text;
}

}  // namespace

std::string draw_model(const Result& r) {
  const double square = checker_square(r);
  return figures::draw_model(
      {.title = r.options.model.filename().string() + ", " + r.energy.name(),
       .subtitle = subtitle(r, square),
       .model = {r.domain.input.vertices, r.domain.input.triangles, r.layout.uv, r.domain.open().triangles,
                 square, r.layout.flipped, outlines(r.domain)}});
}

}  // namespace isostretch::app::parameterize
