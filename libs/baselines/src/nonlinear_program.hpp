#pragma once

#include <isostretch/baselines/result.hpp>

#include <span>
#include <string>

namespace isostretch::baselines {

// minimise f(x)  such that  c(x) >= 0  and  lower <= x <= upper, with exact derivatives, as solvers of
// nonlinear programs ask for it. These solvers are modules of their own, loaded when they are asked for,
// which see this header and none of the library's functions.
class NonlinearProgram {
 public:
  struct Sizes {
    int unknowns = 0, constraints = 0, jacobian_entries = 0, hessian_entries = 0;
  };

  virtual ~NonlinearProgram() = default;
  virtual Sizes sizes() const = 0;
  // Infinite where there is no bound.
  virtual void bounds(std::span<double> lower, std::span<double> upper) const = 0;
  virtual void start(std::span<double> x) const = 0;

  virtual double value(std::span<const double> x) const = 0;
  virtual void gradient(std::span<const double> x, std::span<double> g) const = 0;
  virtual void constraints(std::span<const double> x, std::span<double> c) const = 0;
  virtual void jacobian_structure(std::span<int> rows, std::span<int> columns) const = 0;
  virtual void jacobian(std::span<const double> x, std::span<double> values) const = 0;
  // The lower triangle of factor * Hessian of f + the sum of multipliers times those of c. What falls
  // together is added up.
  virtual void hessian_structure(std::span<int> rows, std::span<int> columns) const = 0;
  virtual void hessian(std::span<const double> x, double factor, std::span<const double> multipliers,
                       std::span<double> values) const = 0;

  // The next iterate, by the solver's own number; x is empty where it has none to show. False: stop.
  virtual bool take_iterate(int iteration, std::span<const double> x) = 0;
  // The answer.
  virtual void finish(std::span<const double> x) = 0;
};

struct ProgramOptions {
  double tolerance = 1e-6;
  int iterations = -1;           // at most; negative: the solver's own limit
  double seconds = 0;            // at most; infinite: no limit
  const char* algorithm = "";    // where a module has several
  double step_tolerance = 1e-6;  // where it ends by the change in one step
};

struct ProgramOutcome {
  Status status = Status::not_run;
  std::string message;
};

// What a module exports: runs until the end. What the program's functions throw comes through.
using SolveProgram = void (*)(NonlinearProgram& program, const ProgramOptions& options,
                              ProgramOutcome& outcome);

}  // namespace isostretch::baselines
