#pragma once

#include <isostretch/comparison/method_comparison.hpp>
#include <isostretch/comparison/method_plots.hpp>

#include <string>
#include <vector>

namespace isostretch::comparison {

/// Returns a page without outside resources; the pictures are those of draw_all(), or none.
std::string comparison_page(const MethodComparison& comparison, const std::vector<NamedPicture>& pictures);

}  // namespace isostretch::comparison
