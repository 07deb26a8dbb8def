// Ipopt (Waechter, Biegler 2006) as a module of its own, which nothing but the program's interface ties to
// the library.
#include "nonlinear_program.hpp"

#include <isostretch/core/index.hpp>

#include <IpIpoptApplication.hpp>
#include <IpIpoptCalculatedQuantities.hpp>
#include <IpIpoptData.hpp>
#include <IpOrigIpoptNLP.hpp>
#include <IpTNLP.hpp>
#include <IpTNLPAdapter.hpp>

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

namespace isostretch::baselines {
namespace {

constexpr double infinity = 1e20;  // as Ipopt writes it

class Nlp final : public Ipopt::TNLP {
 public:
  explicit Nlp(NonlinearProgram& program)
      : program_(program), sizes_(program.sizes()), iterate_(at(sizes_.unknowns)) {}

  bool get_nlp_info(Ipopt::Index& n, Ipopt::Index& m, Ipopt::Index& jacobian_entries,
                    Ipopt::Index& hessian_entries, IndexStyleEnum& style) override {
    n = sizes_.unknowns;
    m = sizes_.constraints;
    jacobian_entries = sizes_.jacobian_entries;
    hessian_entries = sizes_.hessian_entries;
    style = C_STYLE;
    return true;
  }

  bool get_bounds_info(Ipopt::Index n, double* x_lower, double* x_upper, Ipopt::Index m, double* c_lower,
                       double* c_upper) override {
    program_.bounds({x_lower, at(n)}, {x_upper, at(n)});
    std::for_each_n(x_lower, n, [](double& bound) { bound = std::max(bound, -infinity); });
    std::for_each_n(x_upper, n, [](double& bound) { bound = std::min(bound, infinity); });
    std::fill_n(c_lower, m, 0.0);
    std::fill_n(c_upper, m, infinity);
    return true;
  }

  bool get_starting_point(Ipopt::Index n, bool, double* x, bool, double*, double*, Ipopt::Index, bool,
                          double*) override {
    program_.start({x, at(n)});
    return true;
  }

  bool eval_f(Ipopt::Index n, const double* x, bool, double& value) override {
    value = program_.value({x, at(n)});
    return true;
  }

  bool eval_grad_f(Ipopt::Index n, const double* x, bool, double* gradient) override {
    program_.gradient({x, at(n)}, {gradient, at(n)});
    return true;
  }

  bool eval_g(Ipopt::Index n, const double* x, bool, Ipopt::Index m, double* c) override {
    program_.constraints({x, at(n)}, {c, at(m)});
    return true;
  }

  bool eval_jac_g(Ipopt::Index n, const double* x, bool, Ipopt::Index, Ipopt::Index entries,
                  Ipopt::Index* rows, Ipopt::Index* columns, double* values) override {
    if (values)
      program_.jacobian({x, at(n)}, {values, at(entries)});
    else
      program_.jacobian_structure({rows, at(entries)}, {columns, at(entries)});
    return true;
  }

  bool eval_h(Ipopt::Index n, const double* x, bool, double objective_factor, Ipopt::Index m,
              const double* multipliers, bool, Ipopt::Index entries, Ipopt::Index* rows,
              Ipopt::Index* columns, double* values) override {
    if (values)
      program_.hessian({x, at(n)}, objective_factor, {multipliers, at(m)}, {values, at(entries)});
    else
      program_.hessian_structure({rows, at(entries)}, {columns, at(entries)});
    return true;
  }

  bool intermediate_callback(Ipopt::AlgorithmMode, Ipopt::Index iteration, double, double, double, double,
                             double, double, double, double, Ipopt::Index, const Ipopt::IpoptData* data,
                             Ipopt::IpoptCalculatedQuantities* quantities) override {
    if (!take_iterate(data, quantities)) return program_.take_iterate(iteration, {});
    return program_.take_iterate(iteration, iterate_);
  }

  void finalize_solution(Ipopt::SolverReturn, Ipopt::Index n, const double* x, const double*, const double*,
                         Ipopt::Index, const double*, const double*, double, const Ipopt::IpoptData*,
                         Ipopt::IpoptCalculatedQuantities*) override {
    program_.finish({x, at(n)});
  }

 private:
  // False where Ipopt has none to show: in its restoration phase it solves another problem.
  bool take_iterate(const Ipopt::IpoptData* data, Ipopt::IpoptCalculatedQuantities* quantities) {
    if (!data || !quantities) return false;
    auto* nlp = dynamic_cast<Ipopt::OrigIpoptNLP*>(Ipopt::GetRawPtr(quantities->GetIpoptNLP()));
    auto* adapter = nlp ? dynamic_cast<Ipopt::TNLPAdapter*>(Ipopt::GetRawPtr(nlp->nlp())) : nullptr;
    if (!adapter) return false;
    adapter->ResortX(*data->curr()->x(), iterate_.data());
    return true;
  }

  NonlinearProgram& program_;
  NonlinearProgram::Sizes sizes_;
  std::vector<double> iterate_;
};

ProgramOutcome outcome_of(Ipopt::ApplicationReturnStatus status) {
  switch (status) {
    case Ipopt::Solve_Succeeded:
      return {Status::converged, "optimal"};
    case Ipopt::Solved_To_Acceptable_Level:
      return {Status::converged, "optimal to Ipopt's acceptable level, not to the tolerance"};
    case Ipopt::Infeasible_Problem_Detected:
      return {Status::claims_infeasible, "converged to a point of local infeasibility"};
    case Ipopt::Search_Direction_Becomes_Too_Small:
      return {Status::stalled, "the search direction became too small"};
    case Ipopt::Diverging_Iterates:
      return {Status::stalled, "the iterates diverge"};
    case Ipopt::Restoration_Failed:
      return {Status::stalled, "the restoration phase failed"};
    case Ipopt::Error_In_Step_Computation:
      return {Status::stalled, "no step could be computed"};
    case Ipopt::Feasible_Point_Found:
      return {Status::stalled, "it found no more than a feasible point"};
    case Ipopt::Maximum_Iterations_Exceeded:
      return {Status::iteration_limit, "the largest number of iterations is reached"};
    case Ipopt::Maximum_CpuTime_Exceeded:
      return {Status::time_limit, "the time limit is reached"};
    case Ipopt::Insufficient_Memory:
      return {Status::memory_limit, "out of memory"};
    default:
      return {Status::failed, "Ipopt ended with code " + std::to_string(status)};
  }
}

}  // namespace

extern "C" void isostretch_solve_by_ipopt(NonlinearProgram& program, const ProgramOptions& options,
                                          ProgramOutcome& outcome);
extern "C" void isostretch_solve_by_ipopt(NonlinearProgram& program, const ProgramOptions& options,
                                          ProgramOutcome& outcome) {
  const Ipopt::SmartPtr<Ipopt::TNLP> nlp = new Nlp(program);
  // Without a console.
  const Ipopt::SmartPtr<Ipopt::IpoptApplication> application = new Ipopt::IpoptApplication(false);
  application->RethrowNonIpoptException(true);
  const auto& list = application->Options();
  list->SetNumericValue("tol", options.tolerance);
  // Measured: the monotone barrier of the default never ends on a stretched bar. Bounds relaxed by 1e-8, its
  // default, let eigenvalues be -1e-4 where two of an element's are small.
  list->SetStringValue("mu_strategy", "adaptive");
  list->SetNumericValue("bound_relax_factor", 0);
  list->SetStringValue("sb", "yes");
  list->SetIntegerValue("print_level", 0);
  if (options.iterations >= 0) list->SetIntegerValue("max_iter", options.iterations);
  const Ipopt::ApplicationReturnStatus status = application->Initialize("");
  outcome = outcome_of(status == Ipopt::Solve_Succeeded ? application->OptimizeTNLP(nlp) : status);
}

}  // namespace isostretch::baselines
