#include "command_line.hpp"
#include "parameterize.hpp"

int main(int argc, char** argv) {
  using namespace isostretch::app;
  parameterize::CommandLine command_line;
  return run_app(
      argc, argv,
      {.name = "isostretch-parameterize",
       .purpose =
           "Flattens a surface with as little distortion as an energy allows, without flipped triangles.",
       .examples = {"isostretch-parameterize model.obj --max-distortion 2 --out out"},
       .renamed = {{"--grad-tol", "--gradient-tolerance"},
                   {"--solver", "--backend"},
                   {"--seams ignore", "--no-input-seams"},
                   {"--seams input", ""}},
       .declare = [&](CLI::App& cli) { command_line.declare(cli); },
       .body =
           [&](const CommonOptions& common) {
             return parameterize::parameterize(command_line.options(), common);
           }});
}
