#pragma once

#include "comparison.hpp"
#include "plots.hpp"

#include <string>
#include <vector>

namespace isostretch::app::compare {

// One page without outside resources; the pictures are those of draw_all(), or none.
std::string report_page(const Comparison& comparison, const std::vector<NamedPicture>& pictures);

}  // namespace isostretch::app::compare
