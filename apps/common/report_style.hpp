#pragma once

#include <isostretch/figures/report_style.hpp>

namespace isostretch::app {

using figures::html::report_style;

}  // namespace isostretch::app
