#include "common/exit_code.hpp"

namespace isostretch::app {

std::string exit_code_help() {
  return "Exit codes:\n"
         "  0  success\n"
         "  1  internal error, or out of memory\n"
         "  2  wrong command line\n"
         "  3  input unreadable or not usable\n"
         "  4  output cannot be written\n"
         "  5  stopped early (iterations, time, Ctrl-C); the best state is written\n"
         "  6  the solver failed, or elements are flipped; the best state is written";
}

}  // namespace isostretch::app
