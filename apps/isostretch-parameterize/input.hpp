#pragma once

#include "options.hpp"

#include <isostretch/mesh_io/obj_document.hpp>
#include <isostretch/surface/check.hpp>
#include <isostretch/surface/repair.hpp>

#include <memory>

namespace isostretch::app::parameterize {

/// The model as it is flattened: read, welded and repaired where that was asked for.
struct Input {
  mesh::SurfaceMesh mesh;
  std::shared_ptr<const mesh::ObjDocument> document;  // of an OBJ file: what the mesh was made of
  mesh::RepairReport repairs;                         // empty without --repair
};

/// Reads the model. Throws Error naming the file for what cannot be read.
Input read_input(const Options& options);

/// Returns whether a surface that cannot be cut to disks could be after --repair.
bool repair_would_help(mesh::SurfaceMesh mesh);

/// Returns whether check() has found nothing that flattening minds. Several components and vertices of no
/// triangle are no obstacle.
bool flattenable(const mesh::MeshDiagnostics& diagnostics);

}  // namespace isostretch::app::parameterize
