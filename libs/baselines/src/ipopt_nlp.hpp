#pragma once

#include "constraint_functions.hpp"
#include "objective.hpp"
#include "recorder.hpp"

#include <IpTNLP.hpp>

#include <string>
#include <vector>

namespace isostretch::baselines {

// minimise f(x) - t  such that  c(x) >= 0, as Ipopt asks for it, with exact derivatives. Hard targets are
// bounds that meet. The shift t, if the constraint functions have one, is below `most_shift`.
class IpoptNlp : public Ipopt::TNLP {
 public:
  // All must outlive this.
  IpoptNlp(const Instance& instance, const Objective& objective, const ConstraintFunctions& constraints,
           Recorder& recorder);

  // The start, dim entries a node, and then the shift, if any.
  void start_at(const std::vector<double>& unknowns) { unknowns_ = unknowns; }
  // Ends as soon as the shift of an iterate is above the first.
  void look_for_shift(double enough, double most);

  Vector positions() const;  // the last that Ipopt showed, in the end its answer
  double shift() const { return unknowns_.back(); }
  bool has_enough() const { return constraints_.with_shift() && shift() > enough_shift_; }
  int iterations() const { return iterations_; }

  bool get_nlp_info(Ipopt::Index& n, Ipopt::Index& m, Ipopt::Index& jacobian_entries,
                    Ipopt::Index& hessian_entries, IndexStyleEnum& style) override;
  bool get_bounds_info(Ipopt::Index n, double* x_lower, double* x_upper, Ipopt::Index m, double* c_lower,
                       double* c_upper) override;
  bool get_starting_point(Ipopt::Index n, bool init_x, double* x, bool init_z, double* z_lower,
                          double* z_upper, Ipopt::Index m, bool init_lambda, double* lambda) override;
  bool eval_f(Ipopt::Index n, const double* x, bool new_x, double& value) override;
  bool eval_grad_f(Ipopt::Index n, const double* x, bool new_x, double* gradient) override;
  bool eval_g(Ipopt::Index n, const double* x, bool new_x, Ipopt::Index m, double* c) override;
  bool eval_jac_g(Ipopt::Index n, const double* x, bool new_x, Ipopt::Index m, Ipopt::Index entries,
                  Ipopt::Index* rows, Ipopt::Index* columns, double* values) override;
  bool eval_h(Ipopt::Index n, const double* x, bool new_x, double objective_factor, Ipopt::Index m,
              const double* multipliers, bool new_multipliers, Ipopt::Index entries, Ipopt::Index* rows,
              Ipopt::Index* columns, double* values) override;
  bool intermediate_callback(Ipopt::AlgorithmMode mode, Ipopt::Index iteration, double objective,
                             double primal_infeasibility, double dual_infeasibility, double mu, double step,
                             double regularisation, double dual_step, double primal_step,
                             Ipopt::Index line_search_trials, const Ipopt::IpoptData* data,
                             Ipopt::IpoptCalculatedQuantities* quantities) override;
  void finalize_solution(Ipopt::SolverReturn status, Ipopt::Index n, const double* x, const double* z_lower,
                         const double* z_upper, Ipopt::Index m, const double* c, const double* lambda,
                         double value, const Ipopt::IpoptData* data,
                         Ipopt::IpoptCalculatedQuantities* quantities) override;

 private:
  Vector positions_of(const double* x) const;
  int position_count() const;
  void hessian_structure(Ipopt::Index* rows, Ipopt::Index* columns) const;
  void hessian_values(std::span<const double> x, double objective_factor, std::span<const double> multipliers,
                      double* values) const;
  bool take_iterate(const Ipopt::IpoptData* data, Ipopt::IpoptCalculatedQuantities* quantities);

  const Instance& instance_;
  const Objective& objective_;
  const ConstraintFunctions& constraints_;
  Recorder& recorder_;
  std::vector<double> unknowns_;
  double enough_shift_ = 0, most_shift_ = 0;
  int iterations_ = 0, first_point_;
};

}  // namespace isostretch::baselines
