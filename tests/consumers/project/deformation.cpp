// A bar that is twisted and bent, frame by frame: no element is inverted on the way.
#include "expect.hpp"

#include <isostretch/deformation/sequence.hpp>
#include <isostretch/energies/registry.hpp>

using namespace isostretch;

int main() {
  // snippet: libs/deformation/README.md
  // A bar of hexahedra; load_solid({"body.msh"}) reads one.
  auto bar =
      deformation::load_solid({.generated = deformation::BarSpec{{8, 2, 2}, {4, 1, 1}, mesh::Shape::hex}});
  deformation::SequenceOptions options{.energy = energies::make_energy("symmetric_arap")};
  handles::Keyframe rest{0, {}}, end{1, {.axis = {1, 0, 0}, .degrees = 90}};
  options.script.handles = {
      {.name = "left", .select = handles::Slab{0, handles::End::min, 0.1}, .keyframes = {rest}},
      {.name = "right", .select = handles::Slab{0, handles::End::max, 0.1}, .keyframes = {rest, end}}};
  options.script.frames = 4;
  deformation::Sequence sequence(options, bar);
  deformation::Strain strain(bar.elements);
  while (!sequence.done()) {
    const deformation::FrameResult frame = sequence.next();
    if (!frame.summary.converged() || !strain.at(sequence.positions()).inverted.empty()) return 1;
  }
  // end of snippet
  EXPECT(sequence.frame() == 4);
}
