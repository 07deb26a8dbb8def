#include "common/sequence_report.hpp"

#include "common/deformation_names.hpp"
#include "common/terminal.hpp"

#include <isostretch/core/text.hpp>

#include <utility>
#include <vector>

namespace isostretch::app {

double sum_over(const Json& frames, const char* key) {
  double total = 0;
  for (const Json& frame : frames) total += frame.value(key, 0.0);
  return total;
}

std::string animation_text(const Json& frames) {
  std::vector<std::pair<std::string, double>> files;
  for (const Json& frame : frames)
    files.emplace_back(frame["file"].get<std::string>(), frame["time"].get<double>());
  return pvd_text(files);
}

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

}  // namespace isostretch::app
