#include "command_line.hpp"
#include "compare.hpp"
#include "manipulate.hpp"

int main(int argc, char** argv) {
  using namespace isostretch::app;
  manipulate::CommandLine command_line;
  return run_app(
      argc, argv,
      {.name = "isostretch-manipulate",
       .purpose =
           "Moves and turns parts of a body and lets the rest follow without an inverted element, with a "
           "proof of how close to the best possible.",
       .examples = {"isostretch-manipulate body.msh --handle \"slab:y,min,0.05\" --handle "
                    "\"slab:y,max,0.1;rotate=0,1,0:180\" --out out"},
       .renamed = {{"--solver", "--rival"},
                   {"--repeat", "--repetitions"},
                   {"--gap", "--gap-tolerance"},
                   {"--weights", "--element-weights"},
                   {"--absolute", "--length-unit=mesh"},
                   {"--method skinning", "--method=unconstrained"},
                   {"--compare nearby", "--compare=alternative"}},
       .declare = [&](CLI::App& cli) { command_line.declare(cli); },
       .body =
           [&](const CommonOptions& common) {
             return command_line.compares() ? manipulate::compare(command_line, common)
                                            : manipulate::manipulate(command_line, common);
           }});
}
