#pragma once

#include "common/deformation_names.hpp"

#include <isostretch/core/choice_names.hpp>
#include <isostretch/core/text.hpp>

#include <string>
#include <utility>
#include <vector>

namespace isostretch::app {

enum class FrameFormat { vtu, obj, msh };
constexpr ChoiceNames<FrameFormat, 3> choice_names(FrameFormat) {
  return {{{"vtu", FrameFormat::vtu}, {"obj", FrameFormat::obj}, {"msh", FrameFormat::msh}}};
}

struct CellField {
  std::string name;
  std::vector<double> values;  // one an element
};

struct NodeField {
  std::string name;
  std::vector<double> values;  // one a node
};

// "frame_0012.vtu".
std::string frame_name(int number, FrameFormat format);

// Throws Error when the format cannot hold the elements of the body: MSH has linear triangles and tets.
void require_holds(FrameFormat format, const SolidModel& body);

// The body at some positions: VTU with its elements, the fields and the displacement of every node, in raw
// doubles; OBJ with its surface; MSH with its elements.
std::string format_frame(FrameFormat format, const SolidModel& body, const Vector& positions,
                         const std::vector<CellField>& fields);

// ParaView's list of the files of an animation with their times.
std::string pvd_text(const std::vector<std::pair<std::string, double>>& file_and_time);

}  // namespace isostretch::app
