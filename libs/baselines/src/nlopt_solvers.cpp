// Algorithms of NLopt on the principal minors, from the minimiser without constraints; in the table also
// where this is built without it.
#include "constrained_program.hpp"
#include "registry.hpp"
#include "solver_module.hpp"
#include "unconstrained.hpp"

#include <string>
#include <vector>

namespace isostretch::baselines {
namespace {

// An algorithm with what it takes.
struct Algorithm {
  const char* name;
  // NLopt ends by the change in one step, which says little about the gap: so much of the tolerance.
  double step_tolerance;
  // Elements beyond which it takes more than ten minutes, extrapolated from this: of 400 triangles MMA and
  // CCSA take ten seconds and more a step (each solves a dual problem with as many unknowns as there are
  // functions), SLSQP 0.6 s (each is the cube of the unknowns; of 144 triangles it needs 400 steps), and
  // AUGLAG takes up to 5000 evaluations of a dense Jacobian, which has 0.4 GB with 3000 tets.
  int most_elements;
};
constexpr Algorithm mma = {"MMA", 1, 200}, ccsaq = {"CCSAQ", 1, 200}, slsqp = {"SLSQP", 1e-3, 500},
                    auglag = {"AUGLAG", 1e-3, 3000};

Vector optimize(const Algorithm& algorithm, const Instance& instance, const Options& options,
                Recorder& recorder) {
  if (const int elements = instance.problem.element_count(); elements > algorithm.most_elements) {
    recorder.end(Status::not_applicable, std::to_string(elements) + " elements are too many for " +
                                             algorithm.name + ", whose matrices are dense: beyond " +
                                             std::to_string(algorithm.most_elements) +
                                             " it takes more than ten minutes");
    return {};
  }
  const EnergyObjective objective(instance.problem);
  const ConstraintFunctions constraints(instance.problem, ConstraintForm::principal_minors);
  ConstrainedProgram program(instance, objective, constraints, recorder);
  const Vector start = skinned(instance.problem);
  program.start_at({start.begin(), start.end()});
  const SolveProgram solve = load_solver("isostretch_nlopt", "isostretch_solve_by_nlopt");
  recorder.begin(Recorder::Phase::solving);
  ProgramOutcome outcome;
  solve(program,
        {.tolerance = options.tolerance,
         .iterations = options.limits.iterations,
         .seconds = options.stop.seconds_left(),
         .algorithm = algorithm.name,
         .step_tolerance = algorithm.step_tolerance * options.tolerance},
        outcome);
  recorder.end(outcome.status, outcome.message);
  recorder.result().iterations = program.last_iteration() + 1;
  return program.positions();
}

template <const Algorithm& algorithm>
Vector run(const Instance& instance, const Options& options, Recorder& recorder) {
  return optimize(algorithm, instance, options, recorder);
}

}  // namespace

std::vector<Entry> nlopt_solvers() {
#if defined(ISOSTRETCH_WITH_NLOPT)
  const std::string needs;
#else
  const std::string needs = "isostretch was built without NLopt (Debian: libnlopt-dev)";
#endif
  return {{{"nlopt_mma", "NLopt MMA", "Svanberg 2002", Kind::convex, needs}, run<mma>},
          {{"nlopt_ccsaq", "NLopt CCSA", "Svanberg 2002: quadratic approximations", Kind::convex, needs},
           run<ccsaq>},
          {{"nlopt_slsqp", "NLopt SLSQP", "Kraft 1994", Kind::convex, needs}, run<slsqp>},
          {{"nlopt_auglag", "NLopt AUGLAG", "Birgin, Martinez 2008; inside, L-BFGS of Luksan", Kind::convex,
            needs},
           run<auglag>}};
}

}  // namespace isostretch::baselines
