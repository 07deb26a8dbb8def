#pragma once

#include <isostretch/core/choice_names.hpp>
#include <isostretch/core/vector.hpp>
#include <isostretch/deformation/solid_model.hpp>
#include <isostretch/handles/bounded_weights.hpp>
#include <isostretch/mesh_io/fields.hpp>

#include <string>
#include <utility>
#include <vector>

namespace isostretch::deformation {

/// The file formats of the frames of a sequence.
enum class FrameFormat {
  vtu,  ///< All elements, fields, and the displacement of every node, in raw doubles.
  obj,  ///< The surface of the body.
  msh   ///< Linear triangles or tets.
};
/// Returns the names of the formats in scenes, which are also the extensions of the files.
constexpr ChoiceNames<FrameFormat, 3> choice_names(FrameFormat) {
  return {{{"vtu", FrameFormat::vtu}, {"obj", FrameFormat::obj}, {"msh", FrameFormat::msh}}};
}

/// Returns the name of the file of a frame, such as "frame_0012.vtu".
std::string frame_name(int number, FrameFormat format);

/// Throws Error if the format cannot hold the elements of the body: MSH has linear triangles and tets.
void require_holds(FrameFormat format, const SolidModel& body);

/// Returns the file of a body at some positions (dim entries a node). Only VTU has the fields, one value an
/// element.
std::string format_frame(FrameFormat format, const SolidModel& body, const Vector& positions,
                         const std::vector<mesh::MeshField>& fields);

/// Returns the VTU file of a body at rest with fields of one value a node.
std::string format_rest(const SolidModel& body, const std::vector<mesh::MeshField>& node_fields);

/// Returns the weights of each handle as a field of nodes: weight_0 and so on.
std::vector<mesh::MeshField> weight_fields(const handles::HandleWeights& weights);

/// Returns ParaView's list (PVD) of the files of an animation with their times.
std::string pvd_text(const std::vector<std::pair<std::string, double>>& file_and_time);

}  // namespace isostretch::deformation
