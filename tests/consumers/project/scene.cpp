// A scene, the same for all programs, is read and run.
#include "expect.hpp"

#include <isostretch/deformation/sequence.hpp>
#include <isostretch/scene/pipelines.hpp>
#include <isostretch/scene/scene_file.hpp>
#include <isostretch/scene/solid.hpp>

using namespace isostretch;

int main() {
  // snippet: libs/scene/README.md
  const scene::Value bar = scene::parse_json(R"({
    "schema": 1,
    "mesh": {"bar": {"cells": [8, 2, 2], "size": [4, 1, 1], "element": "hex"}},
    "energy": "symmetric_arap",
    "handles": [
      {"select": {"slab": {"axis": "x", "end": "min", "fraction": 0.1}}},
      {"select": {"slab": {"axis": "x", "end": "max", "fraction": 0.1}},
       "rotate": {"axis": [1, 0, 0], "degrees": 90}}
    ],
    "frames": 4
  })",
                                             "bar");  // scene::read_json("bar.json") reads a file
  const scene::Node node(bar);
  const deformation::SolidModel model = deformation::load_solid(scene::read_solid(node, "."));
  deformation::Sequence sequence(scene::read_sequence(node, model.dim), model);
  while (!sequence.done())
    if (!sequence.next().summary.converged()) return 1;
  // end of snippet
  EXPECT(sequence.frame() == 4);
  scene::check_keys(bar);
  EXPECT(scene::scene_schema().has("properties"));
}
