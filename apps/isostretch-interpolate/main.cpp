#include "command_line.hpp"
#include "interpolate.hpp"

int main(int argc, char** argv) {
  using namespace isostretch::app;
  interpolate::CommandLine command_line;
  return run_app(
      argc, argv,
      {.name = "isostretch-interpolate",
       .purpose = "Leads a body from one pose to another through shapes that are distorted as little as an "
                  "energy allows, without inverted elements.",
       .examples = {"isostretch-interpolate first.msh second.msh --frames 20 --out out"},
       .renamed = {{"--grad-tol", "--gradient-tolerance"},
                   {"--solver", "--backend"},
                   {"--guess", "--initial-guess"}},
       .declare = [&](CLI::App& cli) { command_line.declare(cli); },
       .body = [&](const CommonOptions& common) { return interpolate::interpolate(command_line, common); }});
}
