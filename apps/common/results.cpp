#include "common/results.hpp"

#include "common/terminal.hpp"

#include <isostretch/core/text.hpp>

namespace isostretch::app {

ExitCode conclude(const std::string& verdict, ExitCode code, const OutputFolder& folder,
                  const std::filesystem::path& out, bool verbose) {
  if (verbose)
    for (const auto& path : folder.paths()) print("wrote " + path.string() + "\n");
  else
    print(formatted("wrote %zu files to ", folder.paths().size()) + out.string() + "\n");
  if (code == ExitCode::success)
    print(verdict + "\n");
  else
    report_error(verdict);
  return code;
}

ExitCode show_preview(const figures::HandlePreview& preview, const std::filesystem::path& out) {
  OutputFolder folder(out);
  folder.add("preview.png", figures::draw_preview(preview));
  folder.commit();
  print(figures::preview_table(preview) + "wrote " + folder.paths().back().string() + "\n");
  return ExitCode::success;
}

ExitCode print_check(const deformation::SolidCheck& check) {
  print(check.text);
  if (check.trouble.empty()) {
    print("It can be used.\n");
    return ExitCode::success;
  }
  print("It cannot be used as it is: " + check.trouble + "\n");
  return ExitCode::input;
}

}  // namespace isostretch::app
