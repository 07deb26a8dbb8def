#include "common/preview.hpp"

#include "common/output_folder.hpp"
#include "common/terminal.hpp"

namespace isostretch::app {

ExitCode show_preview(const figures::HandlePreview& preview, const std::filesystem::path& out) {
  OutputFolder folder(out);
  folder.add("preview.png", figures::draw_preview(preview));
  folder.commit();
  print(figures::preview_table(preview) + "wrote " + folder.paths().back().string() + "\n");
  return ExitCode::success;
}

}  // namespace isostretch::app
