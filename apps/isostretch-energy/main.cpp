#include "command_line.hpp"
#include "common/run_app.hpp"
#include "inspect.hpp"

int main(int argc, char** argv) {
  using namespace isostretch::app;
  inspect::CommandLine command_line;
  return run_app(
      argc, argv,
      {.name = "isostretch-energy",
       .purpose =
           "Says what an energy, built in or typed, does: at rest, over a range of stretches, where its "
           "Hessian has negative eigenvalues and of which kind.",
       .examples = {"isostretch-energy \"mu/2*(I2-d) - mu*log(J) + lambda/2*log(J)^2\" --param "
                    "mu=1,lambda=10 --out neo_hookean"},
       .declare = [&](CLI::App& cli) { command_line.declare(cli); },
       .body = [&](const CommonOptions& common) { return inspect::inspect(command_line, common); }});
}
