#pragma once

// Runs of isostretch-deform that must end well, and the frames they write.
#include "deform_app.hpp"

#include <isostretch/mesh/types.hpp>
#include <isostretch/mesh_io/io.hpp>

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

#include <cstdio>
#include <string>
#include <vector>

namespace isostretch::test {

// Runs the scene, which must end well, and returns summary.json.
inline nlohmann::json solved(const Scratch& scratch, const nlohmann::ordered_json& scene,
                             std::vector<std::string> more = {}, const std::string& out = "out") {
  std::vector<std::string> arguments{write_scene(scratch, scene), "-o", scratch.path(out), "--no-picture"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  const Outcome run = deform(arguments);
  REQUIRE_MESSAGE(run.code == 0, run.err);
  return read_json(scratch.path(out + "/summary.json"));
}

inline mesh::Points3 frame(const Scratch& scratch, int number, const std::string& out = "out") {
  char name[64];
  std::snprintf(name, sizeof name, "/frame_%04d.vtu", number);
  return mesh::read_vtu_tets(scratch.path(out + name)).vertices;
}

}  // namespace isostretch::test
