#pragma once

#include "common/exit_code.hpp"

#include <isostretch/figures/handle_preview.hpp>

#include <filesystem>

namespace isostretch::app {

/// Writes the picture to preview.png in that folder and prints the table: what --preview does. Throws Error
/// where it cannot be written.
ExitCode show_preview(const figures::HandlePreview& preview, const std::filesystem::path& out);

}  // namespace isostretch::app
