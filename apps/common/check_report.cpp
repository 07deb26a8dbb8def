#include "common/check_report.hpp"

#include "common/terminal.hpp"

namespace isostretch::app {

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
