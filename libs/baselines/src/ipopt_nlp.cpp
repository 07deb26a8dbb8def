#include "ipopt_nlp.hpp"

#include <IpIpoptCalculatedQuantities.hpp>
#include <IpIpoptData.hpp>
#include <IpOrigIpoptNLP.hpp>
#include <IpTNLPAdapter.hpp>

#include <algorithm>
#include <cstddef>
#include <utility>

namespace isostretch::baselines {
namespace {

constexpr double infinity = 1e20;  // as Ipopt writes it

std::size_t at(int index) {
  return static_cast<std::size_t>(index);
}

}  // namespace

IpoptNlp::IpoptNlp(const Instance& instance, const Objective& objective,
                   const ConstraintFunctions& constraints, Recorder& recorder)
    : instance_(instance),
      objective_(objective),
      constraints_(constraints),
      recorder_(recorder),
      unknowns_(at(constraints.unknowns())),
      first_point_(recorder.points()) {}

void IpoptNlp::look_for_shift(double enough, double most) {
  enough_shift_ = enough;
  most_shift_ = most;
}

int IpoptNlp::position_count() const {
  return constraints_.unknowns() - constraints_.with_shift();
}

Vector IpoptNlp::positions_of(const double* x) const {
  return Eigen::Map<const Vector>(x, position_count());
}

Vector IpoptNlp::positions() const {
  return positions_of(unknowns_.data());
}

bool IpoptNlp::get_nlp_info(Ipopt::Index& n, Ipopt::Index& m, Ipopt::Index& jacobian_entries,
                            Ipopt::Index& hessian_entries, IndexStyleEnum& style) {
  const int columns = constraints_.columns(), elements = instance_.problem.element_count();
  n = constraints_.unknowns();
  m = constraints_.count();
  jacobian_entries = m * columns;
  hessian_entries = elements * (columns * (columns + 1) / 2) + position_count();
  style = C_STYLE;
  return true;
}

bool IpoptNlp::get_bounds_info(Ipopt::Index n, double* x_lower, double* x_upper, Ipopt::Index m,
                               double* c_lower, double* c_upper) {
  std::fill_n(x_lower, n, -infinity);
  std::fill_n(x_upper, n, infinity);
  std::fill_n(c_lower, m, 0.0);
  std::fill_n(c_upper, m, infinity);
  if (constraints_.with_shift()) x_upper[n - 1] = most_shift_;
  const int dim = instance_.dim();
  for (const sdp_penalty::Target& target : instance_.problem.targets)
    for (int r = 0; target.hard && r < dim; ++r)
      x_lower[target.node * dim + r] = x_upper[target.node * dim + r] = target.position[at(r)];
  return true;
}

bool IpoptNlp::get_starting_point(Ipopt::Index, bool, double* x, bool, double*, double*, Ipopt::Index, bool,
                                  double*) {
  std::copy(unknowns_.begin(), unknowns_.end(), x);
  return true;
}

bool IpoptNlp::eval_f(Ipopt::Index n, const double* x, bool, double& value) {
  value = objective_.value(positions_of(x));
  if (constraints_.with_shift()) value -= x[n - 1];
  return true;
}

bool IpoptNlp::eval_grad_f(Ipopt::Index n, const double* x, bool, double* gradient) {
  objective_.gradient(positions_of(x), {gradient, at(position_count())});
  if (constraints_.with_shift()) gradient[n - 1] = -1;
  return true;
}

bool IpoptNlp::eval_g(Ipopt::Index n, const double* x, bool, Ipopt::Index m, double* c) {
  constraints_.values({x, at(n)}, {c, at(m)});
  return true;
}

bool IpoptNlp::eval_jac_g(Ipopt::Index n, const double* x, bool, Ipopt::Index m, Ipopt::Index entries,
                          Ipopt::Index* rows, Ipopt::Index* columns, double* values) {
  if (values) {
    constraints_.jacobian({x, at(n)}, {values, at(entries)});
    return true;
  }
  for (int row = 0; row < m; ++row)
    for (int column = 0; column < constraints_.columns(); ++column) {
      *rows++ = row;
      *columns++ = constraints_.unknown(row / constraints_.per_element(), column);
    }
  return true;
}

bool IpoptNlp::eval_h(Ipopt::Index n, const double* x, bool, double objective_factor, Ipopt::Index m,
                      const double* multipliers, bool, Ipopt::Index, Ipopt::Index* rows,
                      Ipopt::Index* columns, double* values) {
  if (values)
    hessian_values({x, at(n)}, objective_factor, {multipliers, at(m)}, values);
  else
    hessian_structure(rows, columns);
  return true;
}

// The lower triangle of every element's block, then the diagonal. Ipopt adds up what falls together.
void IpoptNlp::hessian_structure(Ipopt::Index* rows, Ipopt::Index* columns) const {
  for (int e = 0; e < instance_.problem.element_count(); ++e)
    for (int i = 0; i < constraints_.columns(); ++i)
      for (int j = 0; j <= i; ++j)
        std::tie(*columns++, *rows++) = std::minmax({constraints_.unknown(e, i), constraints_.unknown(e, j)});
  for (int dof = 0; dof < position_count(); ++dof) *rows++ = *columns++ = dof;
}

void IpoptNlp::hessian_values(std::span<const double> x, double objective_factor,
                              std::span<const double> multipliers, double* values) const {
  const int size = constraints_.columns();
  const std::size_t per_element = at(constraints_.per_element());
  std::vector<double> block(at(size * size));
  for (int e = 0; e < instance_.problem.element_count(); ++e) {
    std::fill(block.begin(), block.end(), 0.0);
    objective_.add_hessian(e, objective_factor, block, size);
    constraints_.add_hessian(e, x, multipliers.subspan(at(e) * per_element, per_element), block);
    for (int i = 0; i < size; ++i)
      for (int j = 0; j <= i; ++j) *values++ = block[at(i * size + j)];
  }
  for (int dof = 0; dof < position_count(); ++dof)
    *values++ = objective_factor * objective_.hessian_diagonal(dof);
}

// False where Ipopt has none to show: in its restoration phase it solves another problem.
bool IpoptNlp::take_iterate(const Ipopt::IpoptData* data, Ipopt::IpoptCalculatedQuantities* quantities) {
  if (!data || !quantities) return false;
  auto* nlp = dynamic_cast<Ipopt::OrigIpoptNLP*>(Ipopt::GetRawPtr(quantities->GetIpoptNLP()));
  auto* adapter = nlp ? dynamic_cast<Ipopt::TNLPAdapter*>(Ipopt::GetRawPtr(nlp->nlp())) : nullptr;
  if (!adapter) return false;
  adapter->ResortX(*data->curr()->x(), unknowns_.data());
  return true;
}

bool IpoptNlp::intermediate_callback(Ipopt::AlgorithmMode, Ipopt::Index iteration, double, double, double,
                                     double, double, double, double, double, Ipopt::Index,
                                     const Ipopt::IpoptData* data,
                                     Ipopt::IpoptCalculatedQuantities* quantities) {
  iterations_ = iteration;
  if (!take_iterate(data, quantities)) return recorder_.may_go_on();
  return recorder_.record(positions(), first_point_ + iteration) && !has_enough();
}

void IpoptNlp::finalize_solution(Ipopt::SolverReturn, Ipopt::Index n, const double* x, const double*,
                                 const double*, Ipopt::Index, const double*, const double*, double,
                                 const Ipopt::IpoptData*, Ipopt::IpoptCalculatedQuantities*) {
  std::copy_n(x, n, unknowns_.begin());
}

}  // namespace isostretch::baselines
