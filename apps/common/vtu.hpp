#pragma once

#include "common/deformation_names.hpp"

#include "common/frames.hpp"

#include <string>
#include <vector>

namespace isostretch::app {

// A body of any elements as VTK's unstructured grid in XML, numbers as raw doubles at the end: its nodes at
// `points`, `displacement` from the rest shape, and the fields.
std::string vtu_text(const SolidModel& body, const mesh::Points3& points,
                     const std::vector<CellField>& fields, const std::vector<NodeField>& node_fields = {});

}  // namespace isostretch::app
