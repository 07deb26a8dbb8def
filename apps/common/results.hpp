#pragma once

#include "common/exit_code.hpp"

#include <isostretch/core/output_folder.hpp>
#include <isostretch/deformation/solid_check.hpp>
#include <isostretch/figures/handle_preview.hpp>

#include <filesystem>
#include <string>

// What apps write and say at their end.
namespace isostretch::app {

/// Prints what was written and, in the last line, the verdict, as an error unless the code is success;
/// returns the code.
ExitCode conclude(const std::string& verdict, ExitCode code, const OutputFolder& folder,
                  const std::filesystem::path& out, bool verbose);

/// Writes the picture to preview.png in that folder and prints the table: what --preview does. Throws Error
/// where it cannot be written.
ExitCode show_preview(const figures::HandlePreview& preview, const std::filesystem::path& out);

/// Prints what a check found and whether the body can be used, what --check does; returns the exit code.
ExitCode print_check(const deformation::SolidCheck& check);

}  // namespace isostretch::app
