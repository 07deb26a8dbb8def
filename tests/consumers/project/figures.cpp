// The convergence of a solve as a picture.
#include "expect.hpp"

#include <isostretch/figures/convergence_plot.hpp>

using namespace isostretch;

int main() {
  figures::Canvas canvas(400, 300);
  newton::Summary summary;
  for (int i = 0; i < 5; ++i) {
    newton::Iteration row;
    row.iteration = i;
    row.energy = 4 + 1.0 / (1 << i);
    row.gradient_inf_norm = 1.0 / (1 << (2 * i));
    summary.trace.push_back(row);
  }
  figures::draw_convergence(canvas, {0, 0, 400, 300}, summary.trace, std::vector<int>(5, 0));
  EXPECT(canvas.file().substr(1, 3) == "PNG");
}
