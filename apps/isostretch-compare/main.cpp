#include "command_line.hpp"
#include "common/run_app.hpp"
#include "compare.hpp"

int main(int argc, char** argv) {
  using namespace isostretch::app;
  compare::CommandLine command_line;
  return run_app(
      argc, argv,
      {.name = "isostretch-compare",
       .purpose = "Runs all methods that minimise distortion on the same problems, and shows how far from "
                  "the optimum each is after how long.",
       .examples = {"isostretch-compare face.obj --energy symmetric_dirichlet --out results"},
       .renamed = {{"--grad-tol", "--gradient-tolerance"}, {"--repeat", "--repetitions"}},
       .declare = [&](CLI::App& cli) { command_line.declare(cli); },
       .body =
           [&](const CommonOptions& common) {
             return command_line.is_single_run()
                        ? compare::run_single(command_line.single_run(), command_line.scene(),
                                              command_line.scene_file())
                        : compare::compare(command_line, common);
           }});
}
