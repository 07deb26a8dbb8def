#pragma once

// The sample mesh in every format and variant, and reading by the extension.
#include "medit_msh_samples.hpp"
#include "sample_mesh.hpp"
#include "surface_samples.hpp"
#include "vtk_samples.hpp"

#include <isostretch/mesh_io/io.hpp>

#include <string>
#include <vector>

namespace isostretch::mesh::test {

inline std::vector<Sample> all_samples(const Variation& variation = {}) {
  std::vector<Sample> samples = {obj_sample(variation), off_sample(variation), stl_sample(false, variation),
                                 stl_sample(true, variation)};
  for (const char* format : {"ascii", "binary_little_endian", "binary_big_endian"})
    samples.push_back(ply_sample(format, variation));
  for (const bool tets : {false, true}) {
    samples.push_back(medit_sample(tets, variation));
    for (const char* version : {"2.2", "4", "4.1"})
      for (const char* coding : {"text", "little", "big"})
        samples.push_back(msh_sample(version, coding, tets, variation));
    for (const bool binary : {false, true}) {
      samples.push_back(vtk_sample(binary, tets, variation));
      samples.push_back(vtk5_sample(binary, tets, variation));
    }
    for (const char* format : {"ascii", "binary", "appended"})
      samples.push_back(vtu_sample(format, tets, variation));
  }
  return samples;
}

inline bool ends_with(const std::string& text, const std::string& end) {
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

inline SurfaceMesh parse_surface(const std::string& name, const std::string& contents,
                                 const ReadOptions& options = {}) {
  if (ends_with(name, ".obj")) return parse_obj(contents, name, options);
  if (ends_with(name, ".off")) return parse_off(contents, name, options);
  if (ends_with(name, ".ply")) return parse_ply(contents, name, options);
  if (ends_with(name, ".stl")) return parse_stl(contents, name, options);
  if (ends_with(name, ".msh")) return parse_msh_surface(contents, name, options);
  if (ends_with(name, ".mesh")) return parse_medit_surface(contents, name, options);
  if (ends_with(name, ".vtk")) return parse_vtk_surface(contents, name, options);
  return parse_vtu_surface(contents, name, options);
}

inline TetMesh parse_tets(const std::string& name, const std::string& contents,
                          const ReadOptions& options = {}) {
  if (ends_with(name, ".msh")) return parse_msh_tets(contents, name, options);
  if (ends_with(name, ".mesh")) return parse_medit_tets(contents, name, options);
  if (ends_with(name, ".vtk")) return parse_vtk_tets(contents, name, options);
  return parse_vtu_tets(contents, name, options);
}

}  // namespace isostretch::mesh::test
