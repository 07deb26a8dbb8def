#include "command_line.hpp"
#include "deform.hpp"

int main(int argc, char** argv) {
  using namespace isostretch::app;
  deform::CommandLine command_line;
  return run_app(argc, argv,
                 {.name = "isostretch-deform",
                  .purpose = "Moves parts of a body and lets the rest follow with as little distortion as an "
                             "energy allows, frame by frame.",
                  .examples = {"isostretch-deform body.msh --handle \"slab:x,min,0.1\" --handle "
                               "\"slab:x,max,0.1;rotate=1,0,0:90\" --frames 20 --out out"},
                  .renamed = {{"--grad-tol", "--gradient-tolerance"},
                              {"--solver", "--backend"},
                              {"--guess", "--initial-guess"}},
                  .declare = [&](CLI::App& cli) { command_line.declare(cli); },
                  .body = [&](const CommonOptions& common) { return deform::deform(command_line, common); }});
}
